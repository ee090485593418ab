#include "solid_space.h"

#include <deltaform/parameters/text.h>
#include <deltaform/process/ranks.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>

namespace deltaform
{
  SolidSpace::SolidSpace(Section &section, const unsigned int degree, const bool axisymmetric)
    : degree_(degree), n_nodes_per_cell_((degree + 1) * (degree + 1)), axisymmetric_(axisymmetric),
      mesh_(section, degree, axisymmetric),
      element_(std::make_unique<dealii::FESystem<2>>(dealii::FE_Q<2>(degree), 2)), dof_handler_(mesh_.triangulation())
  {
  }


  void SolidSpace::set_up(const CellPlaces &places)
  {
    dof_handler_.distribute_dofs(*element_);
    const std::vector<DofIndex> number = hanging_.set_up(dof_handler_);
    cells_.clear();
    nodes_.clear();
    parameters_.clear();
    dofs_.clear();
    if (ranks::count() > 1)
      number_distributed(number, places);
    else
      number_serial(number, places);
  }


  void SolidSpace::number_serial(const std::vector<DofIndex> &number, const CellPlaces &places)
  {
    const dealii::FE_Q<2> scalar(degree_);
    // Curved boundaries of degree 2 where the mesh has manifolds
    const dealii::MappingQ<2> mapping(degree_);
    std::vector<unsigned int> node_of_dof(dof_handler_.n_dofs(), invalid_index);
    std::vector<DofIndex> dofs(element_->n_dofs_per_cell());
    for (const auto &cell : dof_handler_.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      Cell nodes{};
      for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
      {
        const auto dof = dofs[element_->component_to_system_index(0, a)];
        if (node_of_dof[dof] == invalid_index)
        {
          node_of_dof[dof] = nodes_.size();
          parameters_.push_back(mapping.transform_unit_to_real_cell(cell, scalar.unit_support_point(a)));
          nodes_.push_back(places ? places(cells_.size(), a) : mesh_.place(parameters_.back()));
          dofs_.push_back({{number[dof], number[dofs[element_->component_to_system_index(1, a)]]}});
        }
        nodes[a] = node_of_dof[dof];
      }
      cells_.push_back(nodes);
    }
  }


  void SolidSpace::number_distributed(const std::vector<DofIndex> &number, const CellPlaces &places)
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
      dofs_.push_back({{number[r], number[z]}});
    }
    cells_.clear();
    each_node([&](const auto &, const unsigned int a, const DofIndex r, const DofIndex) {
      cells_.back()[a] = node_of_dof[r];
    });
  }


  std::vector<Point2> SolidSpace::positions(const Vector &q) const
  {
    std::vector<Point2> result;
    Vector storage;
    const Vector &u = hanging_.with_hanging(q, storage);
    for (unsigned int i = 0; i < nodes_.size(); ++i)
      result.push_back(position(u, i));
    return result;
  }


  void SolidSpace::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    std::vector<DofIndex> unknowns;
    for (const auto &cell : cells_)
    {
      unknowns.clear();
      for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
        for (const auto i : dofs_[cell[a]])
          hanging_.each_unknown(i, [&](const DofIndex dof, double) { unknowns.push_back(dof); });
      for (const auto i : unknowns)
        for (const auto j : unknowns)
          pattern.add(i, j);
    }
  }


  std::vector<DofIndex> SolidSpace::axis_dofs() const
  {
    std::vector<DofIndex> result;
    for (unsigned int i = 0; i < nodes_.size(); ++i)
      if (axisymmetric_ && std::abs(nodes_[i][0]) < 1e-9 * mesh_.thickness())
        result.push_back(dofs_[i][0]);
    return result;
  }


  std::string SolidSpace::describe(const DofIndex dof) const
  {
    for (unsigned int i = 0; i < nodes_.size(); ++i)
      for (unsigned int k = 0; k < 2; ++k)
        if (dofs_[i][k] == dof)
          return "node " + std::to_string(i) + " (R0 = " + text::format(nodes_[i][0]) +
                 ", Z0 = " + text::format(nodes_[i][1]) + "), " + (k == 0 ? "u_r" : "u_z");
    return "unknown " + std::to_string(dof);
  }


  void SolidSpace::rigid_motion(const Vector &q,
                                const Tensor1 &translation,
                                const double rotation,
                                const std::function<void(DofIndex, double)> &set) const
  {
    for (unsigned int i = 0; i < nodes_.size(); ++i)
    {
      if (dofs_[i][0] >= hanging_.n_unknowns())
        continue;
      const Point2 x = position(q, i);
      set(dofs_[i][0], translation[0] - rotation * x[1]);
      set(dofs_[i][1], translation[1] + rotation * x[0]);
    }
  }
} // namespace deltaform
