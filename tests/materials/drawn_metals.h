#pragma once
// Metals drawn from all registered laws, as entries of a scene.
#include "material_cases.h"

namespace deltaform
{
  namespace testing
  {
    struct DrawnMetal
    {
      std::string name;
      std::vector<std::string> entries; ///< "Material/...=value"
      bool sheet_only; ///< its yield surface is defined in a sheet
    };

    /// A metal of these laws, of drawn parameters; heat with @p softening if @p heats. The heat capacity is large:
    /// random strains would melt the metal.
    inline DrawnMetal draw_metal(const std::string &yield, const std::string &back, const std::string &rate,
                                 const std::string &usual_hardening, const bool heats, const std::string &softening,
                                 std::mt19937 &generator)
    {
      std::vector<std::string> fixed; // by the backstress
      const std::string hardening = hardening_for(back, usual_hardening, fixed);
      const bool own = hardening == "flow curves"; // it knows rate and temperature
      std::vector<std::string> entries;
      const auto add = [&](const std::vector<std::string> &more) {
        entries.insert(entries.end(), more.begin(), more.end());
      };
      if (heats)
      {
        add({"Material/Heat/Adiabatic=true", "Material/Heat/Heat capacity=3000"});
        if (!own)
          for (const auto &entry : law_entries<Softening>("Heat", softening))
            if (entry.find("/Law=") == std::string::npos)
              entries.push_back(entry);
        entries.push_back("Material/Heat/Softening=" + (own ? "none" : softening));
      }
      add(law_entries<YieldSurface>("Yield surface", yield));
      add(law_entries<BackStress>("Backstress", back));
      add(law_entries<RateFactor>("Rate factor", own ? "none" : rate));
      const bool size_is_fixed = !fixed.empty();
      for (const auto &entry : law_entries<Hardening>("Hardening", hardening))
        if (!(size_is_fixed && entry.find("/Flow stress=") != std::string::npos))
          entries.push_back(entry);
      entries = drawn(entries, generator);
      add(fixed);
      add({"Material/Model=elastoplastic", "Material/Young's modulus=69004", "Material/Poisson's ratio=.3"});
      return {yield + ", " + hardening + ", " + back + (own ? "" : ", " + rate) + (heats ? ", heat, " + softening : ""),
              entries,
              yield == "yld2000-2d"};
    }

    /// The laws of the program; those that a test has registered are named "test: ...".
    template <typename Kind>
    std::vector<std::string> names_of()
    {
      auto names = Registry<Kind>::names();
      names.erase(std::remove_if(names.begin(), names.end(),
                                 [](const std::string &name) { return name.rfind("test: ", 0) == 0; }),
                  names.end());
      return names;
    }

    /// Every yield surface with every backstress; hardening, rate factor and heat in turn.
    inline std::vector<DrawnMetal> drawn_metals(const unsigned int seed)
    {
      std::mt19937 generator(seed);
      auto hardenings = names_of<Hardening>(), rates = names_of<RateFactor>(), softenings = names_of<Softening>();
      for (auto *const names : {&hardenings, &rates, &softenings})
        std::shuffle(names->begin(), names->end(), generator);
      std::vector<DrawnMetal> result;
      unsigned int next = 0;
      for (const auto &yield : names_of<YieldSurface>())
        for (const auto &back : names_of<BackStress>())
        {
          const auto turn = [&](const std::vector<std::string> &names) { return names[next % names.size()]; };
          result.push_back(
            draw_metal(yield, back, turn(rates), turn(hardenings), next % 2 == 1, turn(softenings), generator));
          ++next;
        }
      return result;
    }

    /// Every yield surface with every backstress and rate factor, each with heat and without; hardening and softening
    /// in turn. Flow curves, which know the rate themselves, take the place of a rate factor as well.
    inline std::vector<DrawnMetal> metals_of_all_pairs(const unsigned int seed)
    {
      std::mt19937 generator(seed);
      auto rates = names_of<RateFactor>();
      rates.emplace_back("flow curves");
      auto hardenings = laws_of_strain(), softenings = names_of<Softening>();
      hardenings.erase(std::remove_if(hardenings.begin(), hardenings.end(),
                                      [](const std::string &name) { return name.rfind("test: ", 0) == 0; }),
                       hardenings.end());
      std::vector<DrawnMetal> result;
      unsigned int next = 0;
      for (const auto &yield : names_of<YieldSurface>())
        for (const auto &back : names_of<BackStress>())
          for (const auto &rate : rates)
            for (const bool heats : {false, true})
            {
              const bool curves = rate == "flow curves";
              const auto turn = [&](const std::vector<std::string> &names) { return names[next % names.size()]; };
              result.push_back(draw_metal(yield, back, curves ? "none" : rate, curves ? rate : turn(hardenings), heats,
                                          turn(softenings), generator));
              ++next;
            }
      return result;
    }
  } // namespace testing
} // namespace deltaform
