#pragma once

#include "shell_space.h"

#include <deltaform/assembly/contact_surface.h>

#include <array>
#include <limits>
#include <vector>

namespace deltaform
{
  /**
   * The meridian of a shell as a smooth curve: between neighbouring nodes a cubic Hermite polynomial whose tangents are
   * those of the undeformed meridian, turned by the nodal rotations. The tangents' length is that of the accepted
   * state, so that places depend on every rotation by itself. doc/theory/contact.md, "Points inside the elements".
   */
  class ShellMeridian
  {
  public:
    explicit ShellMeridian(const ShellSpace &space);

    /// The mesh is another one.
    void set_up();

    /// Between two neighbouring nodes: an element of degree 1, half of one of degree 2.
    unsigned int n_pieces() const
    {
      return pieces_.size();
    }

    /// Describe the place @p xi (0 to 1) of a piece at @p q: row of unknowns, nodes that carry it, coordinates.
    void describe(const Vector &q, unsigned int piece, double xi, ContactPoint &result) const;

    /// Its derivatives there.
    ContactSurface::FaceCurve curve(const Vector &q, unsigned int piece, double xi) const;

    /// Only its place and the nodes that carry it.
    void locate(const Vector &q, unsigned int piece, double xi, ContactPoint &result) const;

    /// Derivative of a place of a piece at @p q by xi (length).
    Tensor1 rate(const Vector &q, unsigned int piece, double xi) const;

    /// Area per unit of xi at a place of a piece at @p q: of the full circumference, or per unit width.
    double area(const Vector &q, unsigned int piece, double xi) const;

    /// An upper bound of how far a place of a piece moves if the unknowns of both ends change by @p change.
    double largest_motion(unsigned int piece, const std::array<double, ContactPoint::max_dofs> &change) const;

    /// An increment was accepted.
    void update(const Vector &q);

    std::vector<double> &tangent_lengths()
    {
      return length_;
    }
    const std::vector<double> &tangent_lengths() const
    {
      return length_;
    }

  private:
    struct Direction
    {
      double angle = std::numeric_limits<double>::quiet_NaN(); ///< of which it is
      Tensor1 value;
    };

    struct Piece
    {
      std::array<unsigned int, 2> nodes;
      std::array<double, 2> angle; ///< of the undeformed tangent at its ends
    };

    /// What an end of a piece contributes to a place of it.
    struct End
    {
      double share, weight; ///< linear; of the place of the end
      double along_r, along_z; ///< by the tangent there
    };

    /// Add an end to a place of a piece, as the @p k-th node that carries it.
    End add_end(const Vector &q, unsigned int piece, double xi, unsigned int end, unsigned int k, ContactPoint &result)
      const;

    /// Direction of the tangent at an end of a piece. The points of a piece ask for the same one in turn: it is kept.
    const Tensor1 &direction(const Vector &q, unsigned int piece, unsigned int end) const;

    /// Angle of the tangent at an end of a piece.
    double angle(const Vector &q, const Piece &piece, const unsigned int end) const
    {
      return piece.angle[end] + space_.rotation(q, piece.nodes[end]);
    }

    const ShellSpace &space_;
    std::vector<Piece> pieces_;
    std::vector<double> length_; ///< of the tangents of a piece
    mutable std::vector<std::array<Direction, 2>> directions_; ///< at the ends of a piece, as last asked for
  };
} // namespace deltaform
