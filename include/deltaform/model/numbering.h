#pragma once

#include <deltaform/stage/actors.h>

#include <deal.II/base/index_set.h>

#include <array>
#include <vector>

namespace deltaform
{
  /**
   * The unknowns of a model and what each of them is: first those of the blank, then the multipliers of contact
   * points if the enforcement has any, last those that border the sparse matrix: the travels of force-driven tools, and
   * the sizes of loads that follow a way.
   */
  class Numbering
  {
  public:
    Numbering() = default;

    /// Number the unknowns of the blank's present mesh, and tell the interfaces theirs.
    explicit Numbering(Actors &actors);

    unsigned int n_blank = 0, n_sparse = 0, n_border = 0;

    unsigned int n() const
    {
      return n_sparse + n_border;
    }

    dealii::IndexSet owned; ///< rows of the matrix that this process keeps

    /// Of every unknown: makes rotations comparable with displacements and moments with forces. A multiplier is a
    /// force: divided by a stiffness it compares with displacements, its row (a gap) times it with forces.
    std::vector<double> scale;

    std::vector<double> size; ///< of the numbers from which the forces of an unknown are computed (coordinates, angles)
    std::vector<bool> is_fixed; ///< stays zero: symmetry at the axis
    std::array<Vector, 2> translation; ///< of the blank along r and z, by a unit

    /// Unknowns to which contact may add entries of the tangent.
    std::vector<DofIndex> contact_unknowns;

    /// Sum of forces on the unknowns of the blank.
    Tensor1 resultant(const Vector &forces) const;

    /// Motions of the blank as a rigid body, over all unknowns, each with 1 as its largest value.
    std::vector<Vector> rigid_motions(const Blank &blank) const;

  private:
    /// Multipliers come after the last rows of the blank.
    void share_rows(const Blank &blank);
    void measure(const Blank &blank);
  };
} // namespace deltaform
