#pragma once

#include <deltaform/assembly/term.h>
#include <deltaform/model/numbering.h>
#include <deltaform/solver/linear_solver.h>
#include <deltaform/solver/system.h>
#include <deltaform/stage/actors.h>

#include <vector>

namespace deltaform
{
  /// The unknowns on the blank's present mesh, how they couple, and the linear solver for them.
  class Discretization
  {
  public:
    /// @param terms of all stages: they tell the couplings
    Discretization(Actors &actors, const LinearSolverSettings &linear_solver, std::vector<const Term *> terms);

    /// Number the unknowns of another mesh.
    void renumber();

    const Numbering &numbering() const
    {
      return numbering_;
    }

    /// How many meshes there have been: a system belongs to one of them.
    unsigned int n_meshes() const
    {
      return n_meshes_;
    }

    /// An empty linear system for the unknowns.
    System make_system() const;

    /// As chosen for the present mesh.
    const LinearSolverSettings &linear_solver() const
    {
      return linear_solver_;
    }

    /// Is the blank's stiffness assembled and factorized once?
    bool on_linear_path() const
    {
      return linear_solver_.linear_path && actors_.blank->constant_stiffness();
    }

  private:
    /// Of the sparse unknowns, into an empty @p pattern.
    void add_couplings(dealii::DynamicSparsityPattern &pattern) const;

    Actors &actors_;
    LinearSolverSettings linear_solver_;
    std::vector<const Term *> terms_;
    Numbering numbering_;
    std::size_t front_width_ = 0; ///< of the direct factorization (unknowns)
    unsigned int n_meshes_ = 0;
  };
} // namespace deltaform
