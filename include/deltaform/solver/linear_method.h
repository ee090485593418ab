#pragma once

#include <memory>

namespace deltaform
{
  class LinearSolver;
  struct LinearSolverSettings;
  struct TrilinosMatrix;

  /// A way to solve linear systems: makes a solver for a matrix. Registered by its name in the scene.
  class LinearMethod
  {
  public:
    virtual ~LinearMethod() = default;

    /// An iterative one wants a symmetric matrix to stay one, and has tolerances.
    virtual bool iterative() const = 0;

    virtual std::unique_ptr<LinearSolver> make(const LinearSolverSettings &settings,
                                               std::unique_ptr<TrilinosMatrix> matrix) const = 0;
  };
} // namespace deltaform
