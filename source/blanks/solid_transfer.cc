#include "solid_transfer.h"

#include <deltaform/kinematics/logarithmic_strain.h>
#include <deltaform/process/ranks.h>

#include <deal.II/distributed/cell_data_transfer.templates.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/numerics/cell_data_transfer.templates.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    using CellData = SolidTransfer::CellData;

    /// Numbers of a point after its history: ln C_p^-1 / 2, elastic strain, volume offset.
    constexpr std::size_t n_tensors = 9;

    /// A place of the unit cell of a child in its parent's.
    Point2 in_parent(const Point2 &xi, const unsigned int child)
    {
      const unsigned int right = child % 2, upper = child / 2;
      return {.5 * (xi[0] + right), .5 * (xi[1] + upper)};
    }

    /// Lagrange's polynomials of the points of Gauss's rule of the parent, at a place.
    std::vector<double> point_weights(const std::vector<Point2> &points, const Point2 &xi)
    {
      const auto n = static_cast<unsigned int>(std::lround(std::sqrt(points.size())));
      std::vector<double> result;
      const auto line = [&](const unsigned int i, const double x) {
        double product = 1.;
        for (unsigned int k = 0; k < n; ++k)
          if (k != i)
            product *= (x - points[k][0]) / (points[i][0] - points[k][0]);
        return product;
      };
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          result.push_back(line(i, xi[0]) * line(j, xi[1]));
      return result;
    }
  } // namespace


  CellData SolidTransfer::pack(const unsigned int cell, const std::vector<Vector> &fields) const
  {
    const SolidSpace &space = body_.space();
    const unsigned int per_cell = body_.points().per_cell();
    CellData data;
    for (unsigned int a = 0; a < space.n_nodes_per_cell(); ++a)
      for (unsigned int k = 0; k < 2; ++k)
        data.push_back(space.nodes()[space.cells()[cell][a]][k]);
    for (const auto &field : fields)
      for (unsigned int a = 0; a < space.n_nodes_per_cell(); ++a)
        for (const auto dof : space.dofs()[space.cells()[cell][a]])
          data.push_back(field[dof]);
    for (unsigned int i = cell * per_cell; i < (cell + 1) * per_cell; ++i)
    {
      const double *const history = material_.history(i);
      data.insert(data.end(), history, history + material_.law().history_size());
      const auto &cp = motion_.plastic_metric(i);
      const Mandel metric = LogarithmicStrain::strain({cp[0], cp[1], cp[2], cp[3]});
      data.insert(data.end(), metric.begin(), metric.end());
      const Mandel elastic = material_.law().elastic_strain(material_.committed_stress(i));
      data.insert(data.end(), elastic.begin(), elastic.end());
      data.push_back(motion_.volume_offset(i));
      for (unsigned int k = 0; k < material_.criteria().n_fields(); ++k)
        data.push_back(material_.criteria().value(i, k));
    }
    return data;
  }


  void SolidTransfer::divide_cells(const std::vector<Vector> &fields)
  {
    const SolidSpace &space = body_.space();
    std::vector<Vector> all_nodes;
    for (const auto &field : fields)
    {
      Vector storage;
      all_nodes.push_back(space.hanging().with_hanging(field, storage));
    }
    std::vector<CellData> own;
    for (unsigned int c = 0; c < space.cells().size(); ++c)
      own.push_back(pack(c, all_nodes));

    using Cell = dealii::Triangulation<2>::cell_iterator;
    auto &triangulation = body_.space().triangulation();
    const auto divide = [this](const Cell &, const CellData &parent) {
      std::vector<CellData> children;
      for (unsigned int child = 0; child < 4; ++child)
        children.push_back(child_of(parent, child));
      return children;
    };
    // Nothing is coarsened.
    const auto unite = [](const Cell &, const std::vector<CellData> &children) { return children.front(); };

    if (ranks::count() == 1)
    {
      dealii::CellDataTransfer<2, 2, std::vector<CellData>> transfer(triangulation, divide, unite);
      transfer.prepare_for_coarsening_and_refinement();
      triangulation.execute_coarsening_and_refinement();
      cells_.resize(triangulation.n_active_cells());
      transfer.unpack(own, cells_);
      return;
    }

    // Cells move to other processes, so that each has equally many again.
    std::vector<CellData> old(triangulation.n_active_cells());
    unsigned int c = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        old[cell->active_cell_index()] = own[c++];
    auto &distributed = dynamic_cast<dealii::parallel::distributed::Triangulation<2> &>(triangulation);
    dealii::parallel::distributed::CellDataTransfer<2, 2, std::vector<CellData>> transfer(
      distributed, false, divide, unite);
    transfer.prepare_for_coarsening_and_refinement(old);
    triangulation.execute_coarsening_and_refinement();
    std::vector<CellData> all(triangulation.n_active_cells());
    transfer.unpack(all);
    cells_.clear();
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        cells_.push_back(std::move(all[cell->active_cell_index()]));
  }


  CellData SolidTransfer::child_of(const CellData &parent, const unsigned int child) const
  {
    const std::size_t n = body_.space().n_nodes_per_cell(), n_points = body_.points().per_cell();
    const std::size_t n_history = material_.law().history_size();
    const std::size_t n_vectors = (parent.size() - n_points * n_state()) / (2 * n);
    CellData result(parent.size(), 0.);
    interpolate_nodes(parent, child, n_vectors, result);
    if (n_history > 0)
      interpolate_points(&parent[2 * n_vectors * n], child, &result[2 * n_vectors * n]);
    return result;
  }


  void SolidTransfer::interpolate_nodes(const CellData &parent,
                                        const unsigned int child,
                                        const std::size_t n_vectors,
                                        CellData &result) const
  {
    // Displacements and places: exactly, since the parent's shape functions are among those of the children.
    const dealii::FE_Q<2> shapes(body_.space().degree());
    const std::size_t n = body_.space().n_nodes_per_cell();
    std::vector<std::vector<double>> weights(n, std::vector<double>(n));
    for (unsigned int b = 0; b < n; ++b)
      for (unsigned int a = 0; a < n; ++a)
      {
        const double weight = shapes.shape_value(a, in_parent(shapes.unit_support_point(b), child));
        const double round = std::round(weight);
        weights[b][a] = std::abs(weight - round) < 1e-13 ? round : weight; // old nodes keep their numbers exactly
      }
    for (unsigned int v = 0; v < n_vectors; ++v)
      for (unsigned int b = 0; b < n; ++b)
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int k = 0; k < 2; ++k)
            result[2 * (v * n + b) + k] += weights[b][a] * parent[2 * (v * n + a) + k];
  }


  void SolidTransfer::interpolate_points(const double *const parent,
                                         const unsigned int child,
                                         double *const result) const
  {
    // Plastic state: interpolated between the parent's points, towards their mean as far as the equivalent plastic
    // strain would leave the range that a linear one with these values has at the points of the children, or get
    // negative. The logarithm of C_p^-1 has no trace, whatever the weights.
    const auto &unit_points = body_.points().unit_points();
    const std::size_t n_points = unit_points.size(), n_state = this->n_state();
    const auto equivalent = [&](const double *const state) { return material_.law().equivalent_plastic_strain(state); };
    CellData mean(n_state, 0.), state(n_state);
    double least = equivalent(parent), most = least;
    for (unsigned int p = 0; p < n_points; ++p)
    {
      least = std::min(least, equivalent(parent + p * n_state));
      most = std::max(most, equivalent(parent + p * n_state));
      for (unsigned int k = 0; k < n_state; ++k)
        mean[k] += parent[p * n_state + k] / n_points;
    }
    const double middle = equivalent(mean.data());
    const double first = unit_points.front()[0], reach = .5 * first / (1. - 2. * first);
    const double range = most - least;
    most += reach * range;
    least = std::max(0., least - reach * range);
    for (unsigned int p = 0; p < n_points; ++p)
    {
      const auto w = point_weights(unit_points, in_parent(unit_points[p], child));
      std::fill(state.begin(), state.end(), 0.);
      for (unsigned int s = 0; s < n_points; ++s)
        for (unsigned int k = 0; k < n_state; ++k)
          state[k] += w[s] * parent[s * n_state + k];
      const double value = equivalent(state.data());
      // A little less, so that round-off does not make a strain negative.
      const double part = value > most    ? (1. - 1e-14) * (most - middle) / (value - middle)
                          : value < least ? (1. - 1e-14) * (least - middle) / (value - middle)
                                          : 1.;
      for (unsigned int k = 0; k < n_state; ++k)
        result[p * n_state + k] = part == 1. ? state[k] : mean[k] + part * (state[k] - mean[k]);
    }
  }


  Vector SolidTransfer::unpack_field(const unsigned int field) const
  {
    const SolidSpace &space = body_.space();
    const std::size_t n = space.n_nodes_per_cell();
    const DofIndex n_unknowns = space.hanging().n_unknowns();
    Vector values(n_unknowns);
    for (unsigned int c = 0; c < space.cells().size(); ++c)
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int k = 0; k < 2; ++k)
          if (const DofIndex dof = space.dofs()[space.cells()[c][a]][k];
              dof < n_unknowns && space.hanging().owned().is_element(dof))
            values[dof] = cells_[c][2 * ((field + 1) * n + a) + k];
    ranks::sum(values.begin(), values.size());
    return values;
  }


  const double *SolidTransfer::state_of(const unsigned int point, const std::size_t n_fields) const
  {
    const unsigned int per_cell = body_.points().per_cell();
    return &cells_[point / per_cell][2 * (n_fields + 1) * body_.space().n_nodes_per_cell() +
                                     point % per_cell * n_state()];
  }


  std::size_t SolidTransfer::n_state() const
  {
    return material_.law().history_size() + n_tensors + material_.criteria().n_fields();
  }


  void SolidTransfer::unpack_points(const std::size_t n_fields)
  {
    const std::size_t n_history = material_.law().history_size();
    std::vector<double> history, criteria;
    for (unsigned int i = 0; i < body_.points().size(); ++i)
    {
      const double *state = state_of(i, n_fields);
      history.insert(history.end(), state, state + n_history);
      state += n_history;
      motion_.volume_offset(i) = state[8];
      const auto b = LogarithmicStrain::inverse({{state[0], state[1], state[2], state[3]}});
      motion_.set_plastic_metric(i, {{b.xx, b.yy, b.zz, b.xy}});
      // Polynomials may overshoot what only grows from zero.
      for (unsigned int k = 0; k < material_.criteria().n_fields(); ++k)
        criteria.push_back(std::max(0., state[n_tensors + k]));
    }
    material_.set_history(history);
    material_.criteria().set_values(std::move(criteria));
  }


  void SolidTransfer::take_over(std::vector<Vector> &fields)
  {
    kernel_.reset();
    for (unsigned int v = 0; v < fields.size(); ++v)
      fields[v] = unpack_field(v);
    unpack_points(fields.size());

    // Stresses of the law at the displacements as they came over, the scale of energies and the start of the next flow.
    const SolidPoints &points = body_.points();
    const Vector q = fields.empty() ? Vector(body_.space().hanging().n_unknowns()) : fields.front();
    kernel_.update_stress(q);
    if (const std::size_t n_history = material_.law().history_size(); n_history > 0 && !fields.empty())
    {
      std::vector<Mandel> elastic;
      for (unsigned int i = 0; i < points.size(); ++i)
      {
        const double *const state = state_of(i, fields.size()) + n_history + 4;
        elastic.push_back({{state[0], state[1], state[2], state[3]}});
      }
      keep_elastic_strain(elastic);
      kernel_.update_stress(q);
    }
    kernel_.discard_matrices();
    material_.keep_stress();
    motion_.keep();
    if (material_.account().counts())
    {
      double elastic = 0.;
      for (unsigned int i = 0; i < points.size(); ++i)
        elastic += points[i].weight * material_.law().elastic_energy(material_.stress(i));
      material_.account().add(ranks::sum(elastic), 0.);
    }
    cells_.clear();
  }


  void SolidTransfer::keep_elastic_strain(const std::vector<Mandel> &wanted)
  {
    // At displacements that did not change, children strain otherwise than their parent's points did: the less, the
    // less it was distorted. Where metal has flowed, that difference belongs to the flow and not to the elasticity,
    // whose strains are a thousand times smaller; where it has not, it is what the finer mesh knows better.
    const unsigned int per_cell = body_.points().per_cell();
    const auto share = [&](const double plastic, const double flow_stress) {
      return plastic / (flow_stress / material_.law().young_modulus() + plastic);
    };
    for (unsigned int c = 0; c < body_.space().cells().size(); ++c)
    {
      double plastic = 0., flow_stress = 0.;
      for (unsigned int i = c * per_cell; i < (c + 1) * per_cell; ++i)
      {
        plastic += material_.equivalent_plastic_strain(i) / per_cell;
        flow_stress += material_.flow_stress(i) / per_cell;
      }
      const double volume_share = share(plastic, flow_stress);
      for (unsigned int i = c * per_cell; i < (c + 1) * per_cell; ++i)
      {
        // The law got the sum of the elastic strain and the plastic one of its history.
        Mandel trial = material_.strain(i);
        const Mandel old = material_.plastic_strain(i);
        for (unsigned int k = 0; k < 4; ++k)
          trial[k] -= old[k];
        const double mean = (trial[0] + trial[1] + trial[2]) / 3.;
        const double wanted_mean = (wanted[i][0] + wanted[i][1] + wanted[i][2]) / 3.;
        motion_.volume_offset(i) += 3. * volume_share * (mean - wanted_mean);
        // Small strains are as linear in the cell as what is interpolated.
        if (!motion_.finite())
          continue;
        const double own = share(material_.equivalent_plastic_strain(i), material_.flow_stress(i));
        Mandel kept;
        for (unsigned int k = 0; k < 4; ++k)
          kept[k] = (1. - own) * (trial[k] - (k < 3 ? mean : 0.)) + own * (wanted[i][k] - (k < 3 ? wanted_mean : 0.));
        motion_.flow_to(i, kept);
      }
    }
  }
} // namespace deltaform
