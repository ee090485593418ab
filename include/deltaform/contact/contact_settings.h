#pragma once

#include <deltaform/assembly/delta_size.h>
#include <deltaform/contact/normal_law.h>
#include <deltaform/contact/penalty_rule.h>
#include <deltaform/parameters/time_function.h>

#include <map>
#include <memory>
#include <string>

namespace deltaform
{
  class Section;

  /// Entries of the Contact section, which all interfaces share.
  struct ContactSettings
  {
    /// @param constants what the allowed penetration and slip may use beside t: "thickness", "edge"
    /// @param natural_length the constant of which they are a thousandth by default
    ContactSettings(Section &section,
                    const std::map<std::string, double> &constants,
                    const std::string &natural_length = "thickness");

    /// Are contact points springs that keep their penetration? Augmented ones end without, like exact constraints.
    bool stores_energy() const
    {
      return normal_law->augmentation_tolerance() == 0;
    }

    /// Of the allowed penetration at the start, against the natural length (thickness; solids: shortest edge).
    DeltaSize delta_size(const double natural_length) const
    {
      constexpr double coarse = 1e-4;
      return allowed_penetration(0.) >= coarse * natural_length ? DeltaSize::coarse : DeltaSize::fine;
    }

    /// Is the factor of every contact point found so that it keeps delta?
    bool finds_factors() const
    {
      return normal_law->uses_penalty() && stores_energy() && rule->promises();
    }

    std::unique_ptr<NormalLaw> normal_law;
    std::unique_ptr<PenaltyRule> rule;
    TimeFunction allowed_penetration;
    TimeFunction allowed_slip;
    double tangential_factor;
    double tangential_floor;
  };
} // namespace deltaform
