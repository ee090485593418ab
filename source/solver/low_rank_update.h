#pragma once
// A matrix whose factorization is kept, plus a few entries that change; private to the solver.
#include <deltaform/assembly/types.h>

#include <Eigen/Dense>

#include <functional>
#include <vector>

namespace deltaform
{
  /// An entry of the tangent behind its constant part.
  struct UpdateEntry
  {
    DofIndex row, column;
    double value;
  };

  /**
   * Solves (F + E D E^T) d + B w = b, C d_A + W w = b_w, where F is factorized for good, E picks the unknowns A that D,
   * B or C have entries for, and w are unknowns of a border: with the compliance G = E^T F^-1 E,
   *
   *     d_A + G (D d_A + B_A w) = (F^-1 b)_A,    C d_A + W w = b_w,    d = F^-1 b - F^-1 E (D d_A + B_A w).
   *
   * The columns of G are computed when an unknown is in A for the first time. In contact mechanics G is the compliance
   * of the contact nodes; the formula is that of Sherman, Morrison, Woodbury (W.W. Hager, Updating the inverse of a
   * matrix, SIAM Review 31 (1989) 221). D consists of small blocks D = U S V^T, one per contact node; the unknowns are
   * S V^T d_A, forces in the principal directions: large factors S would amplify the round-off of V^T d_A, and small
   * ones that of S^-1. The equations are scaled accordingly.
   */
  class LowRankUpdate
  {
  public:
    /// Solution for a right side with a one at unknown @p dof, at the candidates. @return false if there is none
    using Compliance = std::function<bool(DofIndex dof, Eigen::VectorXd &result)>;

    /// The border of a system: columns and rows over the unknowns in front of it, and the block between them.
    struct Border
    {
      const std::vector<Vector> &columns, &rows;
      Eigen::MatrixXd block;
      Eigen::VectorXd right_side;
    };

    /**
     * @param candidates   for A, rising
     * @param largest_rank with more unknowns in A, factorizing the sum is faster
     */
    LowRankUpdate(std::vector<DofIndex> candidates, std::size_t largest_rank);

    const std::vector<DofIndex> &candidates() const
    {
      return candidates_;
    }

    /// Place among the candidates, or invalid_index.
    unsigned int find(DofIndex dof) const;

    /// F is another one, and @p ground of every candidate is what was added to the diagonal of F to make it regular: D
    /// takes it off again.
    void restart(const Eigen::VectorXd &ground);

    /// Set D to the sum of @p entries, without rows of unknowns that are @p prescribed, and A to the unknowns that
    /// take part, among them @p bordered ones. @return false if one is no candidate or A is too large
    bool set(const std::vector<UpdateEntry> &entries,
             const std::vector<DofIndex> &bordered,
             const std::vector<bool> &prescribed);

    /**
     * @param d          F^-1 b
     * @param forces     out: b less of this is the right side for which F has the solution d: D d_A + B_A w on A
     * @param w          out: unknowns of the border
     * @return false if the sum is (nearly) singular
     */
    bool solve(const Vector &d,
               const Border &border,
               const std::vector<bool> &prescribed,
               const Compliance &compliance,
               Vector &forces,
               Eigen::VectorXd &w);

    /**
     * Where D is stiff, take d_A from the forces of the last solve(): what F^-1 (b - E D d_A) has lost in round-off is
     * little against d, but not if it is multiplied by a large factor.
     */
    void restore_digits(const std::vector<bool> &prescribed, Vector &d) const;

    unsigned int n_columns() const
    {
      return n_columns_;
    }

  private:
    /// The equations for d_A and w: first with the matrix [G, G B; 0, W], as turn_to_principal() finds it.
    struct Reduced
    {
      Eigen::MatrixXd B, C, matrix;
      Eigen::VectorXd right_side;
    };

    /// Find the columns of G that are not known yet. @return false if there is no solution for one
    bool complete_columns(const Compliance &compliance);

    Reduced reduce(const Vector &d, const Border &border, const std::vector<bool> &prescribed) const;

    /**
     * To unknowns y = S V^T d_A: (S^-1 + V^T G U) y + V^T G B w = V^T (F^-1 b)_A, C V S^-1 y + W w = b_w, with columns
     * multiplied by S where it is small.
     * @return y over the unknown of every column
     */
    Eigen::VectorXd turn_to_principal(Reduced &reduced);

    std::vector<DofIndex> candidates_;
    std::size_t largest_rank_;
    Eigen::VectorXd ground_;
    std::vector<Eigen::VectorXd> columns_; ///< F^-1 e_j at all candidates, by candidate; empty: not needed yet
    std::vector<unsigned int> active_; ///< A, as places among the candidates, block by block

    /// A block of D, for unknowns that follow each other in A.
    struct Block
    {
      Eigen::Index first;
      Eigen::MatrixXd left, right; ///< U, V
      Eigen::VectorXd factors; ///< S
    };
    std::vector<Block> blocks_;
    Eigen::VectorXd principal_; ///< y = S V^T d_A
    std::vector<bool> stiff_; ///< in which of these directions D is stiffer than F
    unsigned int n_columns_ = 0;
  };
} // namespace deltaform
