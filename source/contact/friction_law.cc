#include <deltaform/contact/friction_law.h>
#include <deltaform/parameters/registry.h>

#include <cmath>

namespace deltaform
{
  FrictionResponse FrictionLaw::update(const FrictionInput &input) const
  {
    const double trial = input.committed + input.stiffness * input.slip_increment;
    const FrictionLimit bound = limit(input);
    const double value = input.share * bound.value;
    if (std::abs(trial) <= value)
      return {trial, input.stiffness, 0., 0., true};
    const double sign = trial > 0 ? 1. : -1.;
    if (!input.coupled)
      return {sign * value, 0., sign * bound.rate, 0., false};
    const double mean = bound.value / input.normal_force;
    return {sign * value, 0., sign * mean, sign * input.share * input.area * (bound.rate - mean), false};
  }


  std::unique_ptr<FrictionLaw> make_friction_law(Section &tool_section)
  {
    auto law = Registry<FrictionLaw>::choose(
      tool_section, "Friction law", "coulomb", "Tangential law; without a coefficient there is no friction.");
    return law->acts() ? std::move(law) : nullptr;
  }
} // namespace deltaform
