#include "usable_material.h"

namespace deltaform
{
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
    if (!solid)
      return;
    if (traits.symmetry != Symmetry::isotropic)
      section.fail(model, "a solid does not follow the axes of an anisotropic metal yet: use a shell.");
    for (const auto &field : material.history_layout().fields())
      if (field.kind == HistoryKind::tensor && field.name != "plastic_strain")
        section.fail(model, "a solid does not turn '" + field.name + "' with the metal yet: use a shell.");
  }
} // namespace deltaform
