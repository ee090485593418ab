#pragma once

#include <deltaform/model/numbering.h>
#include <deltaform/solver/linear_solver.h>
#include <deltaform/solver/system.h>
#include <deltaform/stage/actors.h>

#include <memory>

namespace deltaform
{
  /// The unknowns on the blank's present mesh, and the linear system for them.
  class Discretization
  {
  public:
    Discretization(Actors &actors, const LinearSolverSettings &linear_solver);

    /// Number the unknowns of another mesh. The system is the same object as before, empty.
    void renumber();

    const Numbering &numbering() const
    {
      return numbering_;
    }

    System &system()
    {
      return *system_;
    }

    const System &system() const
    {
      return *system_;
    }

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
    Actors &actors_;
    LinearSolverSettings linear_solver_;
    Numbering numbering_;
    std::unique_ptr<System> system_;
  };
} // namespace deltaform
