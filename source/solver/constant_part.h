#pragma once
// A tangent with a part that does not change; private to the solver.
#include "low_rank_update.h"
#include "tangent.h"

#include <vector>

namespace deltaform
{
  class Factorization;
  class PrescribedRows;

  /**
   * The part of a tangent that does not change from pass to pass, factorized once; what a pass adds to it is solved for
   * as an update of low rank. The tangent is kept apart from the solver's matrix, which stays that of the constant
   * part. Derivation: doc/theory/solver.md, "A constant part".
   */
  class ConstantPart
  {
  public:
    /// @param candidates the unknowns that may get entries behind it @param largest_rank and how many of them
    ConstantPart(Tangent &tangent, std::vector<DofIndex> candidates, std::size_t largest_rank);

    /// A pass begins.
    void begin()
    {
      complete_ = false;
    }

    /// Take back what the last pass has added. @return false if there is no constant part yet
    bool restore();

    /// Is it known, but has not got its share of the residual in this pass?
    bool passes_by() const
    {
      return kept_ && !complete_;
    }

    /// Notes what is added to the tangent; null: that is the constant part itself.
    TangentUpdate *update()
    {
      return kept_ ? &changes_ : nullptr;
    }

    /// Is the constant part in the tangent?
    bool known() const
    {
      return kept_;
    }

    /// The constant part has been added. @param tangent with its matrix, which is summed over processes
    void complete(bool tangent);

    /// Motions that cost no energy.
    void set_motions(const std::vector<Vector> &motions)
    {
      motions_ = motions;
    }

    /**
     * Factorize the constant part, if that is not done, and gather the update.
     * @return false if the whole is to be factorized: nothing is known yet, or the update is too large
     */
    bool factorize(PrescribedRows &rows, Factorization &factorization);

    /// The solver's matrix becomes another one.
    void drop()
    {
      prepared_ = condensed_ = false;
    }

    /// Has the last factorize() succeeded?
    bool condensed() const
    {
      return condensed_;
    }

    /// As solve_bordered(). @return false as well if the sum is singular, or nearly
    bool solve(Factorization &factorization,
               const PrescribedRows &rows,
               const Vector &residual,
               const Vector &increments,
               Vector &d);

    /// Solves with the constant part alone for its compliance.
    unsigned int n_compliances() const
    {
      return update_.n_columns();
    }

  private:
    /// Diagonal of the constant part alone: nothing is to depend on when it is factorized.
    double diagonal(DofIndex dof) const;

    /// What to add to the diagonal at the candidates to make the constant part regular. @return false: nothing will do
    bool ground(const std::vector<bool> &prescribed, Eigen::VectorXd &result);

    /// Column @p dof of the compliance, at the candidates.
    bool compliance(Factorization &factorization, DofIndex dof, Eigen::VectorXd &result) const;

    Tangent &tangent_;
    bool kept_ = false; ///< the constant part is in the tangent
    bool complete_ = false; ///< and has got its share of the residual in this pass
    bool condensed_ = false; ///< the last factorize() meant the update, not the whole
    bool prepared_ = false; ///< the solver holds the constant part
    TangentUpdate changes_;
    Vector diagonal_; ///< of distributed rows, of the constant part
    std::vector<Vector> motions_; ///< that cost no energy
    std::vector<bool> prescribed_; ///< when the solver was prepared
    std::vector<bool> isolated_; ///< candidates without entries in the constant part
    LowRankUpdate update_;
  };
} // namespace deltaform
