#include "hanging_nodes.h"

#include <deltaform/process/ranks.h>

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


    /// What the hanging nodes of all processes follow, by the numbers of the DoFHandler.
    void hanging_constraints(const dealii::DoFHandler<2> &dof_handler, dealii::AffineConstraints<double> &result)
    {
      if (ranks::count() == 1)
      {
        dealii::DoFTools::make_hanging_node_constraints(dof_handler, result);
        result.close();
        return;
      }
      // A process finds those of its own nodes; afterwards each knows all of them.
      dealii::IndexSet relevant;
      dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
      dealii::AffineConstraints<double> near(relevant);
      dealii::DoFTools::make_hanging_node_constraints(dof_handler, near);
      std::vector<Master> own;
      for (const auto &line : near.get_lines())
        if (dof_handler.locally_owned_dofs().is_element(line.index))
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
  } // namespace


  std::vector<DofIndex> HangingNodes::set_up(const dealii::DoFHandler<2> &dof_handler)
  {
    dealii::AffineConstraints<double> constraints;
    hanging_constraints(dof_handler, constraints);
    const DofIndex n = dof_handler.n_dofs();
    n_unknowns_ = n - constraints.n_constraints();
    masters_.clear();
    std::vector<DofIndex> number(n);
    DofIndex next = 0, next_hanging = n_unknowns_;
    for (DofIndex i = 0; i < n; ++i)
      number[i] = constraints.is_constrained(i) ? next_hanging++ : next++;
    owned_ = dealii::IndexSet(n_unknowns_);
    for (const DofIndex i : dof_handler.locally_owned_dofs())
      if (number[i] < n_unknowns_)
        owned_.add_index(number[i]);
    owned_.compress();
    for (DofIndex i = 0; i < n; ++i)
      if (constraints.is_constrained(i))
      {
        masters_.emplace_back();
        for (const auto &[master, weight] : *constraints.get_constraint_entries(i))
          masters_.back().emplace_back(number[master], weight);
      }
    return number;
  }


  const Vector &HangingNodes::with_hanging(const Vector &q, Vector &storage) const
  {
    if (masters_.empty())
      return q;
    storage.reinit(n_unknowns_ + masters_.size(), true);
    std::copy_n(q.begin(), n_unknowns_, storage.begin());
    for (unsigned int h = 0; h < masters_.size(); ++h)
    {
      double sum = 0.;
      for (const auto &[master, weight] : masters_[h])
        sum += weight * q[master];
      storage[n_unknowns_ + h] = sum;
    }
    return storage;
  }


  void HangingNodes::add(AssemblyTarget &target,
                         const DofIndex *const dofs,
                         const unsigned int n,
                         const double *const matrix,
                         const double *const vector) const
  {
    if (masters_.empty() || std::all_of(dofs, dofs + n, [&](const DofIndex dof) { return dof < n_unknowns_; }))
      target.add(dofs, n, matrix, vector);
    else
      add_to_masters(target, dofs, n, matrix, vector);
  }


  void HangingNodes::add_to_masters(AssemblyTarget &target,
                                    const DofIndex *const dofs,
                                    const unsigned int n,
                                    const double *const matrix,
                                    const double *const vector) const
  {
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
      each_unknown(dofs[i],
                   [&](const DofIndex dof, const double share) { rows[i].emplace_back(place(dof), share); });
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
