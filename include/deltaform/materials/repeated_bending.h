#pragma once

#include <deltaform/materials/material.h>

#include <optional>
#include <vector>

namespace deltaform
{
  /// Of a strip that is drawn through a bead.
  enum class StripThickness : unsigned char
  {
    stays, ///< as it was
    follows ///< becomes less by the stretch of the mid-surface: the volume stays
  };

  /**
   * Force per width that draws a strip in plane strain over circles without friction: work that bends it to each of
   * the @p radii (of its mid-surface, length) and straightens it again, the first one way, the next the other, per
   * length. A cross-section keeps plane, its strain is that of the mid-surface plus y/R. Without back tension at the
   * entry the tension T grows by the work of the moment, dT = M d(1/R), and stretches the strip meanwhile: T is what
   * leaves the last circle. (After T. B. Stoughton, Model of drawbead forces in sheet metal forming, Proc. 15th IDDRG
   * Congress 1988, 205; there in closed form for one flow curve, here with the metal's own law.)
   *
   * @param law any that can be asked with a given third stress @param thickness of the strip (length)
   * @return nothing where the law gives no stress or the tension tears the strip
   */
  std::optional<double> drawing_force(const Material &law, double thickness, const std::vector<double> &radii,
                                      StripThickness change = StripThickness::follows);
} // namespace deltaform
