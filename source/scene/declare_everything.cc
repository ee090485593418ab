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
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/units_label.h>
#include <deltaform/scene/scene.h>

namespace deltaform
{
  namespace
  {
    template <typename T, typename... Args>
    void declare_each(ParameterTree &tree, const SectionPath &path, const std::string &entry, Args &...args)
    {
      for (const auto &name : Registry<T, Args &...>::names())
      {
        const SectionPath own_path = below(path, entry + ": " + name);
        tree.describe(own_path, Registry<T, Args &...>::sentence(name));
        Section own(tree, own_path);
        Registry<T, Args &...>::make(name, own, args...);
      }
    }
  } // namespace


  void declare_everything(ParameterTree &tree)
  {
    const Scene scene(tree);
    const Blank &blank = *scene.actors.blank;
    declare_each<Blank>(tree, {"Blank"}, "Kind");
    declare_each<Material>(tree, {"Material"}, "Model");
    declare_each<Hardening>(tree, {"Material", "Hardening"}, "Law");
    declare_each<YieldSurface>(tree, {"Material", "Yield surface"}, "Law");
    declare_each<BackStress>(tree, {"Material", "Backstress"}, "Law");
    declare_each<RateFactor>(tree, {"Material", "Rate factor"}, "Law");
    declare_each<Softening>(tree, {"Material", "Heat"}, "Softening");
    Section own_material(tree, {"Material"});
    const auto law = Registry<Material>::choose(own_material, "Model", "elastoplastic", "Stress-strain law.");
    declare_each<FormingLimit>(tree, {"Limits", "forming limit"}, "Curve", std::as_const(*law));
    declare_each<NormalLaw>(tree, {"Contact"}, "Enforcement");
    declare_each<PenaltyRule>(tree, {"Contact"}, "Penalty rule");
    declare_each<Shape>(tree, {"Tools", "<name>"}, "Shape");
    declare_each<FrictionLaw>(tree, {"Tools", "<name>"}, "Friction law");
    declare_each<Measure>(tree, {"Output", "Measures", "<name>"}, "Kind");
    declare_each<Load>(tree, {"Loads", "<name>"}, "Kind", blank);
  }
} // namespace deltaform
