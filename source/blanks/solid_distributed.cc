// A solid whose cells are distributed among processes: nodes are known to all of them, under the same numbers.
#include "solid.h"

#include <deltaform/base/ranks.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>

namespace deltaform
{
  void Solid::set_up_distributed_dofs(const std::vector<DofIndex> &number, const CellPlaces &places)
  {
    const dealii::FE_Q<2> scalar(degree_);
    const dealii::MappingQ<2> mapping(degree_);
    struct Node
    {
      DofIndex r, z;
      std::array<double, 2> parameter, place;
    };
    const auto &owned = dof_handler_.locally_owned_dofs();
    std::vector<Node> own;
    std::vector<bool> seen(dof_handler_.n_dofs(), false);
    std::vector<DofIndex> dofs(element_->n_dofs_per_cell());
    const auto each_node = [&](const auto &action) {
      for (const auto &cell : dof_handler_.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          cells_.emplace_back();
          cell->get_dof_indices(dofs);
          for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
            action(cell,
                   a,
                   dofs[element_->component_to_system_index(0, a)],
                   dofs[element_->component_to_system_index(1, a)]);
        }
    };
    each_node(
      [&](const auto &cell, const unsigned int a, const DofIndex r, const DofIndex z) {
        if (seen[r] || !owned.is_element(r))
          return;
        seen[r] = true;
        const Point2 p = mapping.transform_unit_to_real_cell(cell, scalar.unit_support_point(a));
        const Point2 X = places ? places(cells_.size() - 1, a) : mesh_.place(p);
        own.push_back({r, z, {{p[0], p[1]}}, {{X[0], X[1]}}});
      });

    auto all = ranks::gather(own);
    std::sort(all.begin(), all.end(), [](const Node &a, const Node &b) { return a.r < b.r; });
    std::vector<unsigned int> node_of_dof(dof_handler_.n_dofs(), invalid_index);
    for (const auto &[r, z, parameter, place] : all)
    {
      node_of_dof[r] = nodes_.size();
      parameters_.emplace_back(parameter[0], parameter[1]);
      nodes_.emplace_back(place[0], place[1]);
      node_dofs_.push_back({{number[r], number[z]}});
    }
    cells_.clear();
    each_node([&](const auto &, const unsigned int a, const DofIndex r, const DofIndex) {
      cells_.back()[a] = node_of_dof[r];
    });
  }
} // namespace deltaform
