#pragma once

#include <cmath>

namespace deltaform
{
  /// Energies of the blank since the start of the run (full circumference or per unit width).
  struct BlankEnergy
  {
    double elastic = 0; ///< stored now
    double plastic = 0; ///< dissipated so far, integrated along the path by the trapezoidal rule
    double normal = 0; ///< work of the transverse normal stress so far; part of the above, but not of the virtual work
  };

  /// Energies of contact since the start of the run, summed over the contact points.
  struct ContactEnergy
  {
    double stored = 0; ///< now in the penalty springs: eps penetration^2 / 2, and t^2 / (2 eps_t) of sticking friction
    double friction = 0; ///< dissipated so far
    /// Expected square of its error by long increments, see friction_error()
    double friction_variance = 0;
    double epsilon = 0; ///< what the springs gained beyond the trapezoidal work of their forces on the blank, so far
    double thickness = 0; ///< work on points that the accepted blank has put elsewhere, and on its faces, so far
    /// Work along the face against normal forces so far (no part of the balance): what contact at points resists a sheet
    /// that slides from one to the next. 0 of a smooth face
    double climbing = 0;

    /// Expected error of `friction` against short increments, a standard deviation: sqrt(sum of J^2/12)
    /// over increments and tools, J = sum of (t_1 - t_0) ds over the points of a tool (doc/theory/friction.md). About
    /// proportional to the length of the increments.
    double friction_error() const
    {
      return std::sqrt(friction_variance);
    }

    ContactEnergy &operator+=(const ContactEnergy &other)
    {
      stored += other.stored;
      friction += other.friction;
      friction_variance += other.friction_variance;
      epsilon += other.epsilon;
      thickness += other.thickness;
      climbing += other.climbing;
      return *this;
    }
  };
} // namespace deltaform
