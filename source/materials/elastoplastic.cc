#include "adiabatic_heat.h"
#include "conducted_heat.h"

#include <deltaform/materials/plasticity.h>
#include <deltaform/materials/read_law.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    template <typename Kind>
    std::unique_ptr<Kind> choose(const Section &section, const std::string &default_law, const std::string &sentence)
    {
      Section own = section;
      return Registry<Kind>::choose(own, "Law", default_law, sentence);
    }

    /// How the metal conducts; nothing if it does not.
    std::optional<MetalHeat> read_conduction(Section &section, const double capacity, const Softening &softening)
    {
      MetalHeat heat;
      heat.capacity = capacity;
      heat.melting_rise = softening.melting_rise();
      heat.conductivity = section.number("Conductivity",
                                         0.,
                                         Range::not_negative(),
                                         "force/time/temperature",
                                         "Of heat, in mm, N, s: N/(s K), which is the number of W/(m K). 0: the heat "
                                         "stays where it is made. Solids only, and only with Adiabatic.");
      if (heat.conductivity > 0. || section.documentation())
        heat.initial_temperature = section.number(
          "Initial temperature", required(298.), Range::any(), "temperature", "Of the blank. With Conductivity.");
      return heat.conductivity > 0. ? std::optional(heat) : std::nullopt;
    }

    /// The rate factor with the heat that stays in the metal, if the scene wants it. Of a hardening that knows rate and
    /// temperature itself it is its own one.
    std::unique_ptr<RateFactor> heated(const Hardening &hardening, std::unique_ptr<RateFactor> cold, Section section)
    {
      auto own = hardening.own_rate_factor(0.);
      const bool adiabatic = section.flag(
        "Adiabatic", false, "Compute the temperature. Without Conductivity the heat of flow stays where it is made.");
      if (!adiabatic && !section.documentation())
        return own ? std::move(own) : std::move(cold);
      const double capacity = section.number("Heat capacity",
                                             required(3.432),
                                             Range::positive(),
                                             "stress/temperature",
                                             "Heat capacity per volume: density times specific heat (mm, N, MPa: "
                                             "N/(mm^2 K)). Only with Adiabatic.");
      const double share = section.number("Heated share",
                                          .9,
                                          Range::above_to(0., 1.),
                                          "1",
                                          "Share of the plastic work that becomes heat. Only with Adiabatic.");
      auto softening = Registry<Softening>::choose(
        section, "Softening", "none", "How the flow stress falls with the temperature. Only with Adiabatic.");
      const auto conducts = read_conduction(section, capacity, *softening);
      if (!adiabatic)
        return own ? std::move(own) : std::move(cold);
      if (own && softening->acts())
        section.fail("Softening", "must be none: the law of hardening knows the temperature itself.");
      if (own && conducts && conducts->initial_temperature != own->initial_temperature())
        section.fail("Initial temperature", "must be that of the hardening: both are of the metal at its start.");
      if (own)
      {
        own = hardening.own_rate_factor(share / capacity);
        return conducts ? std::make_unique<ConductedHeat>(std::move(own), *conducts) : std::move(own);
      }
      return std::make_unique<AdiabaticHeat>(std::move(cold), std::move(softening), share / capacity, conducts);
    }

    /// How Young's modulus falls with the plastic strain, if the scene wants it.
    std::optional<FallingModulus> read_falling_modulus(Section section, const Elasticity &elastic)
    {
      const FallingModulus falling{
        section.number("Saturated modulus",
                       elastic.young,
                       Range::positive(),
                       "stress",
                       "Ea, to which Young's modulus falls with the plastic strain e: E = E0 - (E0 - Ea) (1 - exp(-xi "
                       "e)). Default: E0. Shells only."),
        section.number("Rate", 0., Range::not_negative(), "1",
                       "xi, the rate of this fall; 0: Young's modulus is constant.")};
      if (falling.rate > 0. && falling.saturated > elastic.young)
        section.fail("Saturated modulus", "must not be larger than Young's modulus");
      return falling.rate > 0. && falling.saturated < elastic.young ? std::optional(falling) : std::nullopt;
    }

    std::unique_ptr<Material> make(Section &section)
    {
      const Elasticity elastic = read_elasticity(section);
      const auto falling = read_falling_modulus(section.sub("Falling modulus"), elastic);
      FlowLaws laws;
      laws.hardening =
        choose<Hardening>(section.sub("Hardening"), "swift", "Flow stress against the equivalent plastic strain.");
      laws.yield_surface = choose<YieldSurface>(
        section.sub("Yield surface"), "mises", "Equivalent stress; the metal flows along its gradient.");
      const Section back_stress = section.sub("Backstress");
      laws.back_stress = choose<BackStress>(back_stress, "none", "Kinematic hardening.");
      const Section rate_factor = section.sub("Rate factor");
      laws.rate_factor =
        choose<RateFactor>(rate_factor, "none", "How the flow stress depends on the rate of strain.");
      if (laws.rate_factor->acts() && laws.hardening->own_rate_factor(0.))
        rate_factor.fail("Law", "must be none: the law of hardening knows the rate itself.");
      laws.rate_factor = heated(*laws.hardening, std::move(laws.rate_factor), section.sub("Heat"));
      const std::string objection = laws.back_stress->objection(*laws.yield_surface, *laws.hardening);
      if (!objection.empty())
        back_stress.fail("Law", objection);
      const bool two_steps =
        section.choice("Integration",
                       "two steps",
                       {"backward Euler", "two steps"},
                       "How plastic flow is integrated over an increment. two steps: BDF2, of second order, uses the "
                       "increment before. backward Euler: of first order.") == "two steps";
      return std::make_unique<Elastoplastic>(elastic,
                                             std::move(laws),
                                             two_steps ? Elastoplastic::Integration::two_steps
                                                       : Elastoplastic::Integration::backward_euler,
                                             falling);
    }

    const Registry<Material>::Entry
      entry("elastoplastic", "Metal plasticity of a yield surface and laws of hardening, Hencky elasticity", make);
  } // namespace
} // namespace deltaform
