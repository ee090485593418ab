#include "held_forces.h"
#include "cell_search.h"

#include <deltaform/assembly/collector.h>
#include <deltaform/process/ranks.h>

#include <utility>

namespace deltaform
{
  namespace
  {
    /// A force that acts where a node was: undeformed place, components.
    struct NodeForce
    {
      double place[2], force[2];
    };
  } // namespace


  void HeldForces::describe(const Vector &q, KeyedArrays &formed) const
  {
    const SolidSpace &space = body_.space();
    Collector forces(space.hanging().n_unknowns());
    std::vector<NodeForce> result;
    if (kernel_.assemble(q, forces).good())
    {
      ranks::sum(forces.residual.begin(), forces.residual.size());
      for (unsigned int node = 0; node < space.nodes().size(); ++node)
        if (const auto &[r, z] = space.dofs()[node]; r < forces.residual.size() && z < forces.residual.size())
        {
          const Point2 &X = space.nodes()[node];
          result.push_back({{X[0], X[1]}, {forces.residual[r], forces.residual[z]}});
        }
    }
    formed.put("forces on nodes", result);
  }


  std::optional<Vector> HeldForces::come_over(const KeyedArrays &formed) const
  {
    std::vector<NodeForce> forces;
    formed.take("forces on nodes", forces);
    if (forces.empty())
      return std::nullopt;
    const SolidSpace &space = body_.space();
    const std::size_t n = space.n_nodes_per_cell();
    std::vector<double> places;
    std::vector<DofIndex> dofs;
    for (const auto &cell : space.cells())
      for (std::size_t a = 0; a < n; ++a)
        for (unsigned int k = 0; k < 2; ++k)
        {
          places.push_back(space.nodes()[cell[a]][k]);
          dofs.push_back(space.dofs()[cell[a]][k]);
        }
    places = ranks::gather(places);
    dofs = ranks::gather(dofs);
    std::vector<std::vector<double>> cells;
    for (std::size_t first = 0; first < places.size(); first += 2 * n)
      cells.emplace_back(&places[first], &places[first] + 2 * n);
    const CellSearch body(space.degree(), std::move(cells));

    Vector result(space.hanging().n_unknowns());
    for (const NodeForce &force : forces)
    {
      double distance = 0.;
      const auto place = body.find({force.place[0], force.place[1]}, distance);
      if (distance > .1 * space.mesh().thickness())
        continue;
      const auto first = static_cast<std::size_t>(place.cell - body.cells().data()) * 2 * n;
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int k = 0; k < 2; ++k)
          space.hanging().each_unknown(dofs[first + 2 * a + k], [&](const DofIndex dof, const double share) {
            result[dof] += share * body.shape(a, place.xi) * force.force[k];
          });
    }
    return result;
  }
} // namespace deltaform
