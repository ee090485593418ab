#include <deltaform/checks/rigid_motions.h>
#include <deltaform/loads/load_way.h>
#include <deltaform/parameters/text.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Rows of conditions that a motion (along r, along z, rotation; then the travels of tools driven by a force) has
    /// to meet. Lengths are in units of the extent of the blank.
    class Conditions
    {
    public:
      Conditions(const Actors &actors, const unsigned int n_travels)
        : n_(3 + n_travels)
      {
        const Vector zero(actors.blank->n_dofs());
        for (const auto &x : actors.blank->positions(zero))
          extent_ = std::max(extent_, x.norm());
        for (unsigned int k = 0; k < 3; ++k)
        {
          motions_[k].reinit(actors.blank->n_dofs());
          actors.blank->rigid_motion(zero,
                                     k < 2 ? Tensor1({k == 0 ? 1. : 0., k == 1 ? 1. : 0.}) : Tensor1(),
                                     k == 2 ? 1. / extent_ : 0.,
                                     [&](const DofIndex dof, const double value) { motions_[k][dof] = value; });
        }
      }

      void hold(const DofIndex dof, const double scale)
      {
        std::vector<double> row(n_, 0.);
        for (unsigned int k = 0; k < 3; ++k)
          row[k] = motions_[k][dof] * scale;
        rows_.push_back(row);
      }

      /// What a load works on is prescribed, and its size follows: as a support of the mean.
      void hold_way(const LoadWay &way)
      {
        std::vector<double> row(n_, 0.);
        const double size = way.gradient().l1_norm();
        for (unsigned int k = 0; k < 3 && size > 0.; ++k)
          row[k] = (way.gradient() * motions_[k]) / size;
        rows_.push_back(row);
      }

      /// The point @p x must not move along @p normal, but by what the tool of unknown @p travel moves along @p
      /// direction.
      void touch(const Point2 &x, const Tensor1 &normal, const unsigned int travel, const Tensor1 &direction)
      {
        std::vector<double> row(n_, 0.);
        row[0] = normal[0];
        row[1] = normal[1];
        row[2] = (x[0] * normal[1] - x[1] * normal[0]) / extent_;
        if (travel != invalid_index)
          row[3 + travel] = -1. * (direction * normal);
        rows_.push_back(row);
      }

      void forbid(const unsigned int k)
      {
        std::vector<double> row(n_, 0.);
        row[k] = 1.;
        rows_.push_back(row);
      }

      /// Motions of the blank that meet all conditions, in words.
      std::vector<std::string> free_motions() const
      {
        const Eigen::MatrixXd basis = kernel();
        if (basis.cols() == 0)
          return {};
        // The only one is told as it is, of several the unknowns that they move.
        const double size = basis.cwiseAbs().maxCoeff();
        if (basis.cols() == 1 && std::abs(basis(2, 0)) <= 1e-6 * size)
        {
          const double r = basis(0, 0) / size, z = basis(1, 0) / size;
          if (std::abs(r) > 1e-6 && std::abs(z) > 1e-6)
            return {"along the direction (" + text::rounded(r) + ", " + text::rounded(z) + ")"};
        }
        constexpr std::array<const char *, 3> names{{"along r", "along z", "a rotation"}};
        std::vector<std::string> result;
        for (unsigned int k = 0; k < 3; ++k)
          if (basis.row(k).cwiseAbs().maxCoeff() > 1e-6 * size)
            result.emplace_back(names[k]);
        return result;
      }

    private:
      /// Basis of the motions that meet all conditions, a column each.
      Eigen::MatrixXd kernel() const
      {
        Eigen::MatrixXd matrix(rows_.size() + 1, n_);
        matrix.setZero();
        for (unsigned int i = 0; i < rows_.size(); ++i)
          for (unsigned int k = 0; k < n_; ++k)
            matrix(i, k) = rows_[i][k];
        Eigen::FullPivLU<Eigen::MatrixXd> lu(matrix);
        lu.setThreshold(1e-9);
        if (lu.dimensionOfKernel() == 0)
          return Eigen::MatrixXd(n_, 0);
        return lu.kernel();
      }

      unsigned int n_;
      double extent_ = 0.;
      std::array<Vector, 3> motions_;
      std::vector<std::vector<double>> rows_;
    };

    /// Places of the face that may touch: the nodes, also where the contact points lie between them, as a point beside
    /// the foot of a round tool would lean on its flank.
    std::vector<ContactPoint> places_of(const ContactInterface &interface, const Vector &zero)
    {
      const ContactProjector &projector = interface.projector();
      std::vector<ContactPoint> result;
      if (projector.surface().points_per_edge() > 0)
      {
        for (unsigned int e = 0; e < projector.edges().size(); ++e)
          for (const double end : {0., 1.})
            result.push_back(projector.place(zero, e, end));
        return result;
      }
      for (unsigned int i = 0; i < interface.n_points(); ++i)
        if (const ContactPoint node = interface.point(zero, i); node.area > 0)
          result.push_back(node);
      return result;
    }

    /// Those that lie on the tool at the start of the stage, or the one that is nearest to it.
    void add_contact(const ContactInterface &interface,
                     const double time,
                     const unsigned int travel,
                     const Vector &zero,
                     Conditions &conditions)
    {
      const Tool &tool = interface.tool();
      const double way = tool.force_driven() ? 0. : tool.travel(time);
      const auto places = places_of(interface, zero);
      std::vector<Projection> projections;
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto &place : places)
      {
        projections.push_back(tool.project(place.x, way));
        nearest = std::min(nearest, projections.back().distance - place.offset);
      }
      for (std::size_t i = 0; i < places.size(); ++i)
        if (projections[i].distance - places[i].offset <= nearest + 1e-6 * places[i].thickness)
          conditions.touch(places[i].x, projections[i].normal, travel, tool.direction());
    }
  } // namespace


  std::vector<std::string> free_rigid_motions(const Actors &actors, const Stage &stage)
  {
    const bool first = &stage == &actors.stages.front();
    const bool any = std::any_of(
      actors.tools.begin(), actors.tools.end(), [&](const auto &tool) { return tool->exists_in(stage.name); });
    if (any && !first)
      return {};
    const Vector zero(actors.blank->n_dofs());
    unsigned int n_travels = 0;
    for (const auto &tool : actors.tools)
      n_travels += tool->force_driven();
    Conditions conditions(actors, n_travels);
    if (actors.blank->axisymmetric())
      for (const unsigned int k : {0, 2})
        conditions.forbid(k);
    for (const auto &support : actors.supports)
      if (support.acts_in(stage.name))
        for (const auto dof : support.dofs)
          conditions.hold(dof, actors.blank->dof_scale(dof));
    for (const auto &load : actors.loads)
      if (load->follows_way() && load->acts_in(stage.name))
        conditions.hold_way(LoadWay(*load, zero));
    unsigned int travel = 0;
    for (const auto &interface : actors.interfaces)
    {
      const bool by_force = interface->tool().force_driven();
      if (interface->tool().exists_in(stage.name))
        add_contact(*interface, stage.begin, by_force ? travel : invalid_index, zero, conditions);
      travel += by_force;
    }

    return conditions.free_motions();
  }
} // namespace deltaform
