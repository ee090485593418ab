// Hanging nodes of the solid: their displacements are those of the coarse edge on which they lie, so that they are no
// unknowns. All other rooms see free unknowns only; nodes of the boundary, and with them contact, never hang.
#include "solid.h"

#include <deltaform/base/ranks.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /// One of those that a hanging node follows.
    struct Master
    {
      DofIndex hanging, master;
      double weight;
    };
  } // namespace


  void Solid::hanging_constraints(dealii::AffineConstraints<double> &result) const
  {
    if (ranks::count() == 1)
    {
      dealii::DoFTools::make_hanging_node_constraints(dof_handler_, result);
      result.close();
      return;
    }
    // A process finds those of its own nodes; afterwards each knows all of them.
    dealii::IndexSet relevant;
    dealii::DoFTools::extract_locally_relevant_dofs(dof_handler_, relevant);
    dealii::AffineConstraints<double> near(relevant);
    dealii::DoFTools::make_hanging_node_constraints(dof_handler_, near);
    std::vector<Master> own;
    for (const auto &line : near.get_lines())
      if (dof_handler_.locally_owned_dofs().is_element(line.index))
        for (const auto &[master, weight] : line.entries)
          own.push_back({line.index, master, weight});
    const auto all = ranks::gather(own);
    for (const auto &[hanging, master, weight] : all)
    {
      result.add_line(hanging);
      result.add_entry(hanging, master, weight);
    }
    result.close();
  }


  std::vector<DofIndex> Solid::set_up_hanging_nodes()
  {
    dealii::AffineConstraints<double> constraints;
    hanging_constraints(constraints);
    const DofIndex n = dof_handler_.n_dofs();
    n_free_ = n - constraints.n_constraints();
    hanging_.clear();
    std::vector<DofIndex> number(n);
    DofIndex next = 0, next_hanging = n_free_;
    for (DofIndex i = 0; i < n; ++i)
      number[i] = constraints.is_constrained(i) ? next_hanging++ : next++;
    owned_ = dealii::IndexSet(n_free_);
    for (const DofIndex i : dof_handler_.locally_owned_dofs())
      if (number[i] < n_free_)
        owned_.add_index(number[i]);
    owned_.compress();
    for (DofIndex i = 0; i < n; ++i)
      if (constraints.is_constrained(i))
      {
        hanging_.emplace_back();
        for (const auto &[master, weight] : *constraints.get_constraint_entries(i))
          hanging_.back().emplace_back(number[master], weight);
      }
    return number;
  }


  const Vector &Solid::with_hanging(const Vector &q, Vector &storage) const
  {
    if (hanging_.empty())
      return q;
    storage.reinit(n_free_ + hanging_.size(), true);
    std::copy_n(q.begin(), n_free_, storage.begin());
    for (unsigned int h = 0; h < hanging_.size(); ++h)
    {
      double sum = 0.;
      for (const auto &[master, weight] : hanging_[h])
        sum += weight * q[master];
      storage[n_free_ + h] = sum;
    }
    return storage;
  }


  void Solid::add(AssemblyTarget &target,
                  const DofIndex *const dofs,
                  const unsigned int n,
                  const double *const matrix,
                  const double *const vector) const
  {
    if (hanging_.empty() || std::all_of(dofs, dofs + n, [&](const DofIndex dof) { return dof < n_free_; }))
    {
      target.add(dofs, n, matrix, vector);
      return;
    }
    // T^T R and T^T K T with u_cell = T q
    std::vector<DofIndex> own;
    std::vector<std::vector<std::pair<unsigned int, double>>> rows(n);
    const auto place = [&](const DofIndex dof) -> unsigned int {
      const auto found = std::find(own.begin(), own.end(), dof);
      if (found != own.end())
        return found - own.begin();
      own.push_back(dof);
      return own.size() - 1;
    };
    for (unsigned int i = 0; i < n; ++i)
      if (dofs[i] < n_free_)
        rows[i].emplace_back(place(dofs[i]), 1.);
      else
        for (const auto &[master, weight] : hanging_[dofs[i] - n_free_])
          rows[i].emplace_back(place(master), weight);
    const unsigned int m = own.size();
    std::vector<double> residual(m, 0.), tangent(matrix != nullptr ? m * m : 0, 0.);
    for (unsigned int i = 0; i < n; ++i)
      for (const auto &[a, weight] : rows[i])
      {
        residual[a] += weight * vector[i];
        if (matrix != nullptr)
          for (unsigned int j = 0; j < n; ++j)
            for (const auto &[b, other] : rows[j])
              tangent[a * m + b] += weight * other * matrix[i * n + j];
      }
    target.add(own.data(), m, matrix != nullptr ? tangent.data() : nullptr, residual.data());
  }
} // namespace deltaform
