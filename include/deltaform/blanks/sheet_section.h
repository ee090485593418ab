#pragma once

namespace deltaform
{
  /// What a cross-section of a sheet carries, at a node: what a criterion of necking asks for.
  struct SheetSection
  {
    double place     = 0; ///< R0 (length)
    double thickness = 0; ///< current (length)
    double stretch   = 0; ///< meridional logarithmic strain, mean over the thickness
    double thinning  = 0; ///< -ln(thickness/initial thickness)
    double stress    = 0; ///< meridional Kirchhoff stress, mean over the thickness (stress)
  };
} // namespace deltaform
