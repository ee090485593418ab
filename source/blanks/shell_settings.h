#pragma once

namespace deltaform
{
  class Section;

  /// What a scene says of a shell besides its mesh and its material.
  struct ShellSettings
  {
    explicit ShellSettings(Section &section);

    unsigned int degree; ///< 1 with one-point, 2 with two-point reduced integration
    bool axisymmetric; ///< else plane strain
    bool membrane; ///< no bending
    bool transverse_normal_stress; ///< contact pressures count in the yield condition
    double thickness; ///< initial (length)
    double shear_factor;
    static constexpr unsigned int most_layers = 61;
    unsigned int n_layers; ///< points through the thickness
  };
} // namespace deltaform
