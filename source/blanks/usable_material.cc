#include "usable_material.h"

#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/parameters/units_label.h>

namespace deltaform
{
  namespace
  {
    bool knows_temperature(const Material &material)
    {
      return material.history_layout().find("temperature_rise") != nullptr;
    }
  } // namespace


  void check_usable(const Material &material,
                    const ThirdDirection third,
                    const bool axisymmetric,
                    const Section &section)
  {
    const std::string model = "Model";
    const MaterialTraits traits = material.traits();
    const bool solid = third == ThirdDirection::strain_given;
    if (solid ? !traits.strain_given : !traits.stress_given)
      section.fail(model, std::string("this material is for ") + (solid ? "shells" : "solids") + " only.");
    if (axisymmetric && traits.symmetry == Symmetry::orthotropic)
      section.sub("Yield surface")
        .fail("Law",
              "a sheet that differs along and across the rolling direction does not stay a body of revolution: in an "
              "axisymmetric scene r must be the same in all directions of the sheet.");
    if (!solid && material.heat())
      section.sub("Heat").fail("Conductivity",
                               "a shell has no temperature through its thickness, so that heat cannot go to the tools: "
                               "take Blank/Kind = solid, or leave the heat where it is made (0).");
    const auto n_units = text::split(read_units_label(section), ',').size();
    if ((traits.needs_duration || knows_temperature(material)) && n_units > 4)
      section.root().fail("Units",
                          "must name length, force, stress and time, no more: a temperature has no unit of its own, "
                          "all temperatures of a scene are on one scale.");
    if (traits.needs_duration && n_units != 4)
      section.sub(material.heat() ? "Heat" : "Rate factor")
        .fail(material.heat() ? "Conductivity" : "Law",
              "it wants to know in which unit the time of the scene is: name it as the fourth one in Units, for "
              "example 'set Units = mm, N, MPa, s'.");
    if (solid && !traits.section)
      section.fail(model, "this material is for shells only: it is not defined across the thickness.");
  }
} // namespace deltaform
