#pragma once

namespace deltaform
{
  /// What a cross-section of a sheet carries, at a node: what criteria of necking and ironing ask for.
  struct SheetSection
  {
    double place = 0; ///< R0 (length)
    double arc = 0; ///< along the undeformed meridian, from its start (length)
    double thickness = 0; ///< current (length)
    double stretch = 0; ///< meridional logarithmic strain, mean over the thickness
    double thinning = 0; ///< -ln(thickness/initial thickness)
    double stress = 0; ///< meridional Kirchhoff stress, mean over the thickness (stress)
    double contact_pressure = 0; ///< larger one of the contact pressures of both faces, each a mean over one thickness
      ///< (stress)
    double clamping_pressure = 0; ///< smaller one of them (stress)
    double flow_stress = 0; ///< mean over the thickness; 0 where no tools press the section (stress)
  };
} // namespace deltaform
