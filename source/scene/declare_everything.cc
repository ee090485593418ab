// The documentation of all parameters: every registered object declares its entries once.
#include <deltaform/materials/back_stress.h>
#include <deltaform/materials/forming_limit.h>
#include <deltaform/materials/hardening.h>
#include <deltaform/materials/material.h>
#include <deltaform/materials/rate_factor.h>
#include <deltaform/materials/softening.h>
#include <deltaform/materials/yield_surface.h>
#include <deltaform/measures/measure.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/units_label.h>
#include <deltaform/scene/scene.h>

namespace deltaform
{
  namespace
  {
    template <typename T, typename... Args>
    void declare_each(const Section &section, const std::string &entry, Args &...args)
    {
      for (const auto &name : Registry<T, Args &...>::names())
      {
        Section own = section.sub(entry + ": " + name);
        Registry<T, Args &...>::make(name, own, args...);
      }
    }
  } // namespace


  void declare_everything(ParameterTree &tree)
  {
    const Scene scene(tree);
    const Blank &blank = *scene.actors.blank;
    const Section root = tree.root(), material = root.sub("Material"), contact = root.sub("Contact");
    declare_each<Blank>(root.sub("Blank"), "Kind");
    declare_each<Material>(material, "Model");
    declare_each<Hardening>(material.sub("Hardening"), "Law");
    declare_each<YieldSurface>(material.sub("Yield surface"), "Law");
    declare_each<BackStress>(material.sub("Backstress"), "Law");
    declare_each<RateFactor>(material.sub("Rate factor"), "Law");
    declare_each<Softening>(material.sub("Heat"), "Softening");
    Section own_material = material;
    const auto law = Registry<Material>::choose(own_material, "Model", "elastoplastic", "Stress-strain law.");
    declare_each<FormingLimit>(root.sub("Limits").sub("forming limit"), "Curve", std::as_const(*law));
    declare_each<NormalLaw>(contact, "Enforcement");
    declare_each<PenaltyRule>(contact, "Penalty rule");
    declare_each<Shape>(root.sub("Tools").sub("<name>"), "Shape");
    declare_each<FrictionLaw>(root.sub("Tools").sub("<name>"), "Friction law");
    declare_each<Measure>(root.sub("Output").sub("Measures").sub("<name>"), "Kind");
    declare_each<Load>(root.sub("Loads").sub("<name>"), "Kind", blank);
  }
} // namespace deltaform
