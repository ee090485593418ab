#pragma once

#include <deltaform/assembly/types.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <memory>
#include <string>
#include <vector>

class Epetra_CrsMatrix;

namespace deltaform
{
  class Section;

  class LinearMethod;

  /// Which linear solver, and its tolerance.
  struct LinearSolverSettings
  {
    explicit LinearSolverSettings(Section &section);
    explicit LinearSolverSettings(std::string the_name);

    bool iterative() const;

    /// Replace 'automatic' by the faster direct solver for a matrix with @p n rows and this front_width().
    void choose(std::size_t n, std::size_t width);

    std::string name;
    bool automatic = false; ///< name is the program's choice
    std::shared_ptr<const LinearMethod> method; ///< of that name
    double tolerance = 1e-10;
    unsigned int max_iterations = 2000;
    bool linear_path = true; ///< the constant part of a tangent is factorized once

  private:
    static std::shared_ptr<const LinearMethod> method_called(const std::string &name);
  };

  /**
   * Number of unknowns in a front that moves over the mesh from neighbours to neighbours: the width of the level
   * structure of Gibbs, Poole, Stockmeyer, SIAM J. Numer. Anal. 13 (1976) 236. For a strip of any length it is a few
   * times the unknowns across. With several processes, which do not know all couplings, that of a square is returned.
   */
  std::size_t front_width(const dealii::DynamicSparsityPattern &pattern);

  /**
   * A matrix of Trilinos with a fixed pattern and a way to solve with it: Amesos (KLU, MUMPS), or a Krylov method of
   * AztecOO with the algebraic multigrid of ML or with the diagonal as preconditioner.
   */
  class LinearSolver
  {
  public:
    /// All rows in this process.
    static std::unique_ptr<LinearSolver> local(const LinearSolverSettings &settings,
                                               const dealii::DynamicSparsityPattern &pattern);

    /// Rows [@p first, @p end) in this process, the others in the other ones. Collective, as are factorize() and
    /// solve().
    static std::unique_ptr<LinearSolver> distributed(const LinearSolverSettings &settings,
                                                     const dealii::DynamicSparsityPattern &pattern,
                                                     DofIndex first,
                                                     DofIndex end);

    virtual ~LinearSolver() = default;

    virtual Epetra_CrsMatrix &matrix() = 0;

    /// Rigid motions, each a vector of all unknowns; multigrid has to represent them.
    virtual void set_near_null_space(const std::vector<Vector> &, DofIndex, DofIndex)
    {
    }

    /// Discard what is kept from earlier matrices (pivots). A resumed run has none of it and must compute the same to
    /// the last bit.
    virtual void discard_factors()
    {
    }

    /// Call after the values of the matrix have changed. @return false if it is singular, on all processes alike
    virtual bool factorize() = 0;

    /// Does a factorization cost less than a pass over the elements? So it is on thin strips with the pivots of the
    /// last one.
    virtual bool is_cheap() const
    {
      return false;
    }

    /// @param right_side, solution own rows. @return success, on all processes alike
    virtual bool solve(const double *right_side, double *solution) = 0;

    /// Why the last solve() failed although the matrix was not singular, in words; empty if it did not.
    virtual std::string failure() const
    {
      return {};
    }

    virtual unsigned int n_iterations() const
    {
      return 0;
    }
  };
} // namespace deltaform
