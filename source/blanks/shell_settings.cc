#include "shell_settings.h"

#include <deltaform/parameters/section.h>

namespace deltaform
{
  ShellSettings::ShellSettings(Section &section)
    : degree(section.integer("Degree",
                             1,
                             1,
                             2,
                             "Polynomial degree of the elements: 1 for forming, 2 for elastic bending.")),
      axisymmetric(
        section.choice("Symmetry",
                       "axisymmetric",
                       {"axisymmetric", "plane strain"},
                       "Axisymmetric about r = 0 (forces for the full circumference) or plane strain (per unit "
                       "width).") == "axisymmetric"),
      membrane(section.flag("Membrane", false, "No bending: one layer, no rotations. Needs tension to be stable.")),
      transverse_normal_stress(
        section.flag("Transverse normal stress",
                     true,
                     "Put the mean of the contact pressures of both faces into the yield condition of the layers.")),
      thickness(
        section.number("Thickness", required(1.), Range::positive(), "length", "Initial thickness of the blank.")),
      shear_factor(section.number("Shear correction factor",
                                  5. / 6.,
                                  Range::positive(),
                                  "1",
                                  "Factor of the transverse shear stiffness.")),
      n_layers(section.integer("Layers",
                               7,
                               1,
                               most_layers,
                               "Points through the thickness; 15 for springback, 25 where the sheet is bent back."))
  {
    if (membrane)
      n_layers = 1;
    else if (n_layers < 2)
      section.fail("Layers", "one layer has no bending stiffness: set Membrane = true, or use at least 2");
  }
} // namespace deltaform
