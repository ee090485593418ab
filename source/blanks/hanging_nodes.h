#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/types.h>

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>

#include <utility>
#include <vector>

namespace deltaform
{
  /**
   * Displacements of hanging nodes are those of the coarse edge on which they lie, so that they are no unknowns. They
   * are numbered after all unknowns. All other rooms see unknowns only; nodes of the boundary, and with them contact,
   * never hang.
   */
  class HangingNodes
  {
  public:
    /// Number the unknowns of all processes. @return numbers by those of the DoFHandler
    std::vector<DofIndex> set_up(const dealii::DoFHandler<2> &dof_handler);

    /// Number of unknowns; from here on, numbers are those of hanging nodes.
    DofIndex n_unknowns() const
    {
      return n_unknowns_;
    }

    /// Unknowns of this process.
    const dealii::IndexSet &owned() const
    {
      return owned_;
    }

    /// Pass the unknowns, with their shares, that a number stands for to @p action(dof, share).
    template <typename Action>
    void each_unknown(const DofIndex number, const Action &action) const
    {
      if (number < n_unknowns_)
        action(number, 1.);
      else
        for (const auto &[master, weight] : masters_[number - n_unknowns_])
          action(master, weight);
    }

    /// Values of the numbers of all nodes, by those of the unknowns; @p storage is used if there are hanging nodes.
    const Vector &with_hanging(const Vector &q, Vector &storage) const;

    /// Add what belongs to the @p n numbers of a cell's nodes: hanging nodes pass theirs on to their masters.
    /// @p matrix: n x n, row-major, or null.
    void
    add(AssemblyTarget &target, const DofIndex *dofs, unsigned int n, const double *matrix, const double *vector) const;

  private:
    /// add() where some of the nodes hang.
    void add_to_masters(AssemblyTarget &target,
                        const DofIndex *dofs,
                        unsigned int n,
                        const double *matrix,
                        const double *vector) const;

    DofIndex n_unknowns_ = 0;
    dealii::IndexSet owned_;
    std::vector<std::vector<std::pair<DofIndex, double>>> masters_; ///< of the numbers from n_unknowns_ on
  };
} // namespace deltaform
