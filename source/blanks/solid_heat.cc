#include "solid_heat.h"
#include "solid_edge.h"

#include <deltaform/process/ranks.h>

#include <algorithm>

namespace deltaform
{
  SolidHeat::SolidHeat(const SolidDiscretization &body, MaterialPoints &material, const SolidMotion &motion)
    : body_(body), material_(material), motion_(motion), metal_(material.law().heat().value())
  {
    const HistoryField *const rise = material.law().history_layout().find("temperature_rise");
    AssertThrow(rise != nullptr, dealii::ExcInternalError());
    field_ = *rise;
  }


  DofIndex SolidHeat::place_of(const unsigned int node) const
  {
    return body_.space().dofs()[node][0];
  }


  std::vector<double> SolidHeat::at_nodes(const Vector &rise) const
  {
    Vector storage;
    const Vector &values = body_.space().hanging().with_hanging(rise, storage);
    std::vector<double> result;
    for (const auto &dofs : body_.space().dofs())
      result.push_back(values[dofs[0]]);
    return result;
  }


  double SolidHeat::interpolate(const Vector &values, const unsigned int point) const
  {
    const SolidSpace &space = body_.space();
    const auto &cell = space.cells()[point / body_.points().per_cell()];
    double result = 0.;
    for (unsigned int a = 0; a < space.n_nodes_per_cell(); ++a)
      result += body_.points()[point].shape[a] * values[space.dofs()[cell[a]][0]];
    return result;
  }


  SolidHeat::CurrentPoint
  SolidHeat::current(const Vector &q, const unsigned int cell, const unsigned int point) const
  {
    const SolidPoints &points = body_.points();
    const SolidPoint &start = points[cell * points.per_cell() + point];
    const Deformation F = motion_.finite() ? points.deformation(q, cell, point) : Deformation();
    const double determinant = F.f[0] * F.f[3] - F.f[1] * F.f[2];
    CurrentPoint result{{}, determinant * F.hoop * start.weight};
    for (unsigned int a = 0; a < body_.space().n_nodes_per_cell(); ++a) // F^-T dN/dX
      result.gradients.push_back(Tensor1({F.f[3] * start.gradient_r[a] - F.f[2] * start.gradient_z[a],
                                          F.f[0] * start.gradient_z[a] - F.f[1] * start.gradient_r[a]}) /
                                 determinant);
    return result;
  }


  void
  SolidHeat::assemble(const Vector &q_own, const Vector &rise_own, const double duration, AssemblyTarget &target) const
  {
    const SolidSpace &space = body_.space();
    const SolidPoints &points = body_.points();
    Vector storage_q, storage_rise;
    const Vector &q = space.hanging().with_hanging(q_own, storage_q);
    const Vector &rise_n = space.hanging().with_hanging(rise_own, storage_rise);
    const unsigned int n = space.n_nodes_per_cell();
    // Lumped for degree 1: then no node is heated by what cools its neighbour. With degree 2 the corners would have no
    // capacity on the axis.
    const bool lumped = space.degree() == 1;
    std::vector<double> matrix(n * n), vector(n);
    std::vector<DofIndex> dofs(n);
    for (unsigned int c = 0; c < space.cells().size(); ++c)
    {
      std::fill(matrix.begin(), matrix.end(), 0.);
      std::fill(vector.begin(), vector.end(), 0.);
      for (unsigned int a = 0; a < n; ++a)
        dofs[a] = space.dofs()[space.cells()[c][a]][0];
      for (unsigned int p = 0; p < points.per_cell(); ++p)
      {
        const unsigned int i = c * points.per_cell() + p;
        const double capacity = metal_.capacity * points[i].weight;
        const double made = capacity * (rise(i) - interpolate(rise_n, i));
        const CurrentPoint now = current(q, c, p);
        Tensor1 slope;
        for (unsigned int b = 0; b < n; ++b)
          slope += rise_n[dofs[b]] * now.gradients[b];
        const double flux = duration * metal_.conductivity * now.volume;
        for (unsigned int a = 0; a < n; ++a)
        {
          vector[a] += flux * (now.gradients[a] * slope) - points[i].shape[a] * made;
          for (unsigned int b = 0; b < n; ++b)
          {
            matrix[a * n + (lumped ? a : b)] += capacity * points[i].shape[a] * points[i].shape[b];
            matrix[a * n + b] += flux * (now.gradients[a] * now.gradients[b]);
          }
        }
      }
      space.hanging().add(target, dofs.data(), n, matrix.data(), vector.data());
    }
  }


  double SolidHeat::heat_of_flow(const Vector &rise_own) const
  {
    Vector storage;
    const Vector &rise_n = body_.space().hanging().with_hanging(rise_own, storage);
    double sum = 0.;
    for (unsigned int i = 0; i < body_.points().size(); ++i)
      sum += metal_.capacity * body_.points()[i].weight * (rise(i) - interpolate(rise_n, i));
    return ranks::sum(sum);
  }


  double SolidHeat::stored_heat() const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < body_.points().size(); ++i)
      sum += metal_.capacity * body_.points()[i].weight * rise(i);
    return ranks::sum(sum);
  }


  void SolidHeat::give(const Vector &rise_own)
  {
    Vector storage;
    const Vector &values = body_.space().hanging().with_hanging(rise_own, storage);
    for (unsigned int i = 0; i < body_.points().size(); ++i)
      material_.set_value(i, field_, interpolate(values, i));
  }


  std::vector<Conducting::FilmEdge> SolidHeat::edges(const Vector &q, const std::string &part) const
  {
    const SolidSpace &space = body_.space();
    std::vector<FilmEdge> result;
    for (const auto &edge : body_.boundary().edges(part))
    {
      std::array<Point2, 3> x;
      for (unsigned int a = 0; a <= space.degree(); ++a)
        x[a] = motion_.finite() ? space.position(q, edge[a]) : space.nodes()[edge[a]];
      result.push_back({space.degree() + 1, edge, edge_areas(x, space.degree(), space.axisymmetric())});
    }
    return result;
  }
} // namespace deltaform
