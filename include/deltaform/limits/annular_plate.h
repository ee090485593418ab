#pragma once

#include <limits>
#include <vector>

namespace deltaform
{
  /// A point across a flat ring of sheet.
  struct RingPoint
  {
    double r; ///< radius (length)
    double radial, hoop; ///< membrane forces, positive in tension (force/length)
    double stiffness; ///< in bending (force*length)
  };

  /// How a flat ring wrinkles.
  struct Wrinkles
  {
    unsigned int waves = 0; ///< around the circumference; 0: it does not wrinkle
    double factor = std::numeric_limits<double>::infinity(); ///< by which all membrane forces grow until it does
    double pressure = 0.; ///< that keeps waves of the height asked for down (stress); 0: none is needed
  };

  /**
   * Buckling of a flat ring under the membrane forces that it carries: the plate w(r) cos(n phi), hinged at its inner
   * edge, free at the outer one, by the least ratio over n of the energy of bending to the work of the forces,
   *
   *   int D {w''^2 + k^2 + 2 nu w'' k + 2 (1 - nu) n^2 (w'/r - w/r^2)^2} r dr,   k = w'/r - n^2 w/r^2,
   *   -int {N_r w'^2 + N_phi (n w/r)^2} r dr,
   *
   * with cubic elements. A holder of the pressure p, which waves of the height h lift by h, keeps them down
   * where the energy that they set free is less than its work p A h. (S. P. Timoshenko, J. M. Gere, Theory of Elastic
   * Stability, McGraw-Hill 1961; of flanges: B. W. Senior, J. Mech. Phys. Solids 4 (1956) 235.)
   *
   * @param ring from the inner edge to the outer one, two points at least; linear between them
   * @param height of the waves from trough to crest (length)
   */
  Wrinkles wrinkle(const std::vector<RingPoint> &ring, double poisson_ratio, double height);
} // namespace deltaform
