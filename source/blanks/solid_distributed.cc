// A solid whose cells are distributed among processes: nodes are known to all of them, under the same numbers.
#include <deltaform/base/ranks.h>
#include <deltaform/blanks/solid.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>

namespace deltaform
{
  void Solid::set_up_distributed_dofs()
  {
    const dealii::FE_Q<2> scalar(degree_);
    const dealii::MappingQ<2> mapping(degree_);
    struct Node
    {
      DofIndex r, z;
      std::array<double, 2> parameter;
    };
    const auto &owned = dof_handler_.locally_owned_dofs();
    std::vector<Node> own;
    std::vector<bool> seen(dof_handler_.n_dofs(), false);
    std::vector<DofIndex> dofs(element_->n_dofs_per_cell());
    const auto each_node = [&](const auto &action)
    {
      for (const auto &cell : dof_handler_.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
            action(cell,
                   a,
                   dofs[element_->component_to_system_index(0, a)],
                   dofs[element_->component_to_system_index(1, a)]);
        }
    };
    each_node(
      [&](const auto &cell, const unsigned int a, const DofIndex r, const DofIndex z)
      {
        if (seen[r] || !owned.is_element(r))
          return;
        seen[r]        = true;
        const Point2 x = mapping.transform_unit_to_real_cell(cell, scalar.unit_support_point(a));
        own.push_back({r, z, {{x[0], x[1]}}});
      });

    auto all = ranks::gather(own);
    std::sort(all.begin(), all.end(), [](const Node &a, const Node &b) { return a.r < b.r; });
    std::vector<unsigned int> node_of_dof(dof_handler_.n_dofs(), invalid_index);
    for (const auto &[r, z, parameter] : all)
    {
      node_of_dof[r] = nodes_.size();
      parameters_.emplace_back(parameter[0], parameter[1]);
      nodes_.push_back(mesh_.place(parameters_.back()));
      node_dofs_.push_back({{r, z}});
    }
    each_node(
      [&](const auto &, const unsigned int a, const DofIndex r, const DofIndex)
      {
        if (a == 0)
          cells_.emplace_back();
        cells_.back()[a] = node_of_dof[r];
      });
  }
} // namespace deltaform
