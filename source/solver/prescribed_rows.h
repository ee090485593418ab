#pragma once
// Prescribed unknowns in a linear system; private to the solver.
#include <deltaform/assembly/types.h>

#include <vector>

namespace deltaform
{
  class Tangent;

  /**
   * Prescribed unknowns get a row of their own (d = value) and keep their column, so that a prescribed increment moves
   * its neighbours in the same iteration. Where the solver needs a symmetric matrix, the columns move to the right
   * side.
   */
  class PrescribedRows
  {
  public:
    /// @param n number of all unknowns @param symmetric do columns move to the right side?
    PrescribedRows(unsigned int n, bool symmetric);

    void set(const std::vector<bool> &prescribed)
    {
      prescribed_ = prescribed;
    }

    const std::vector<bool> &prescribed() const
    {
      return prescribed_;
    }

    bool symmetric() const
    {
      return symmetric_;
    }

    /**
     * Rows (and columns) of prescribed unknowns in the own rows of a staged matrix.
     * @param scale its largest diagonal entry
     * @param shift is added to the diagonal of the other rows, times the diagonal
     */
    void eliminate(double *staged, const Tangent &tangent, double scale, double shift);

    /// -R with the increments of prescribed unknowns, and what a solution of the eliminated system lacks of it.
    void right_side(const Vector &residual, const Vector &increments, Vector &result) const;

  private:
    std::vector<bool> prescribed_;
    bool symmetric_;
    double row_ = 1.; ///< diagonal of the rows of prescribed unknowns
    struct Eliminated
    {
      DofIndex row, column;
      double value;
    };
    std::vector<Eliminated> eliminated_; ///< entries in columns of prescribed unknowns
  };
} // namespace deltaform
