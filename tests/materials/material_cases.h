#pragma once
// The materials that conformance is asked of, and how it is asked.
#include <deltaform/materials/hardening_laws.h>
#include <deltaform/materials/softening.h>
#include <deltaform/parameters/section.h>

#include "material_point.h"
#include "other_laws.h"

#include <iomanip>
#include <map>

namespace deltaform
{
  namespace testing
  {
    /// See require_close() of numbers.
    inline void require_close(const Mandel &value, const Mandel &expected, const double tolerance,
                              const std::string &what)
    {
      const bool close = norm(difference(value, expected)) <= tolerance;
      const auto text = [](const Mandel &a) {
        std::ostringstream stream;
        stream << std::setprecision(17) << "(" << a[0] << ", " << a[1] << ", " << a[2] << ", " << a[3] << ")";
        return stream.str();
      };
      BOOST_REQUIRE_MESSAGE(close,
                            what << " is " << text(value) << " instead of " << text(expected) << ", which is more than "
                                 << tolerance << " away");
    }

    /// Entries of a registered hardening law that make another one than its documentation does: numbers are scaled.
    inline std::vector<std::string> other_hardening_entries(const std::string &law)
    {
      // What scaling does not change: zeros, and what is no number.
      static const std::map<std::string, std::string> also = {
        {"voce", "Linear modulus=129.24"},
        {"flow curves",
         "Flow curves=0.01 20 0 150; 0.01 20 0.1 290; 0.01 20 0.4 400; 0.01 20 0.8 470; 0.01 90 0 100; "
         "0.01 90 0.1 190; 0.01 90 0.4 200; 0.01 90 0.7 210; 5 20 0 160; 5 20 0.1 300; 5 20 0.4 410; 5 20 0.8 480; "
         "5 90 0 150; 5 90 0.1 210; 5 90 0.4 220; 5 90 0.7 250"},
        {"table", "Flow curve=0 150; 0.03 250; 0.1 290; 0.15 330; 0.4 400; 0.8 470"}};
      std::vector<std::string> result;
      bool changed = false;
      for (const auto &entry : documented_entries([&](ParameterTree &tree) {
             Section section = tree.root();
             Registry<Hardening>::make(law, section);
           }))
      {
        // Of the two-branch power law the documentation has the switch strain, which a scene must not have.
        if (entry.find("Switch strain") == 0)
          continue;
        const std::string other = scaled(entry);
        changed |= !other.empty();
        result.push_back(other.empty() ? entry : other);
      }
      if (also.count(law) > 0)
        result.push_back(also.at(law));
      BOOST_REQUIRE_MESSAGE(changed || also.count(law) > 0, law << ": no second set of parameters is known");
      return result;
    }

    /// The documented entries of a registered law in its section of the scene: "Material/Yield surface/r-bar=1.6".
    template <typename Kind>
    std::vector<std::string> law_entries(const std::string &section, const std::string &law)
    {
      // The documentation shows entries of which a scene must not have all.
      static const std::map<std::string, std::vector<std::string>> not_together = {
        {"hill", {"r0", "r90", "Rolling direction"}}};
      const std::string path = "Material/" + section + "/";
      std::vector<std::string> result = {path + "Law=" + law};
      for (const auto &entry : documented_entries([&](ParameterTree &tree) {
             Section own = tree.root();
             Registry<Kind>::make(law, own);
           }))
      {
        const auto others = not_together.find(law);
        const std::string name = entry.substr(0, entry.find('='));
        if (others == not_together.end() || std::count(others->second.begin(), others->second.end(), name) == 0)
          result.push_back(path + entry);
      }
      return result;
    }

    /// The hardening that a backstress goes together with: @p usual, or one that it asks for, whose entries are added.
    inline std::string
    hardening_for(const std::string &back_stress, const std::string &usual, std::vector<std::string> &entries)
    {
      if (back_stress != "yoshida-uemori")
        return usual;
      entries.emplace_back("Material/Hardening/Flow stress=337");
      return "perfectly plastic";
    }

    /// Entries with every number multiplied by its own factor from .8 to 1.2.
    inline std::vector<std::string> drawn(std::vector<std::string> entries, std::mt19937 &generator)
    {
      std::uniform_real_distribution<double> factor(.8, 1.2);
      for (auto &entry : entries)
      {
        const auto equal = entry.find('=');
        std::istringstream text(entry.substr(equal + 1));
        double value = 0.;
        const bool fixed = entry.find("/Yield stress=") != std::string::npos; // it is that of the hardening
        if (fixed || !(text >> value) || !(text >> std::ws).eof())
          continue;
        std::ostringstream other;
        other << entry.substr(0, equal + 1) << std::setprecision(17) << factor(generator) * value;
        entry = other.str();
      }
      return entries;
    }

    /// A material, and what is expected of it beyond its traits.
    struct MaterialCase
    {
      std::string name;
      std::unique_ptr<Material> material;
      bool mises = true; ///< the equivalent plastic strain is sqrt(2/3) of the plastic strain's length
    };

    /// Registered materials with registered hardening laws, of documented and of other parameters.
    inline void add_registered_cases(std::vector<MaterialCase> &cases)
    {
      const std::vector<std::string> other_entries = {
        "Material/Young's modulus=21000", "Material/Poisson's ratio=.41", "Material/Integration=backward Euler"};
      for (const auto &name : Registry<Material>::names())
        for (const auto &law : Registry<Hardening>::names())
        {
          cases.push_back({name + ", " + law, make_material(name, law)});
          auto entries = other_entries;
          for (const auto &entry : other_hardening_entries(law))
            entries.push_back("Material/Hardening/" + entry);
          cases.push_back({name + ", " + law + ", other parameters", make_material(name, law, entries)});
        }
      const auto add_each = [&](const std::string &section, const auto &entries_of, const auto &laws) {
        for (const auto &law : laws)
        {
          auto entries = entries_of(section, law);
          const std::string hardening = hardening_for(law, "swift", entries);
          cases.push_back({section + " " + law,
                           make_material("elastoplastic", hardening, entries),
                           section != "Yield surface" || law == "mises"});
        }
      };
      add_each("Yield surface", law_entries<YieldSurface>, Registry<YieldSurface>::names());
      add_each("Backstress", law_entries<BackStress>, Registry<BackStress>::names());
      add_each("Rate factor", law_entries<RateFactor>, Registry<RateFactor>::names());
    }

    inline std::unique_ptr<YieldSurface> make_mises()
    {
      ParameterTree tree = ParameterTree::documentation();
      Section section = tree.root();
      return Registry<YieldSurface>::make("mises", section);
    }

    inline std::unique_ptr<YieldSurface> general_mises()
    {
      return std::make_unique<WithoutClosedForm>(make_mises());
    }

    inline std::unique_ptr<YieldSurface> normal_anisotropy(const double r)
    {
      return std::make_unique<Hill48>(r, r, r);
    }

    /// Metals composed of laws that the program does not have, by the general return map.
    inline void add_composed_cases(std::vector<MaterialCase> &cases)
    {
      const auto add = [&](const std::string &name, FlowLaws laws, const bool mises) {
        cases.push_back({name, std::make_unique<Elastoplastic>(Elasticity(69004., .3), std::move(laws)), mises});
      };
      const Swift swift = Swift::parameters().example();
      const Voce voce = Voce::parameters().example();
      const auto chaboche = []() {
        return std::make_unique<Chaboche>(std::vector<Chaboche::Part>{{2000., 20.}, {300., 0.}});
      };
      const auto rate = []() { return std::make_unique<CowperSymondsWithHeat>(40.4, 5., 2e-3, .3); };
      add("general Mises, Swift", {hardening_of(swift), general_mises()}, true);
      add("general Mises, perfectly plastic", {hardening_of(PerfectlyPlastic{120.}), general_mises()}, true);
      add("general Mises, Ludwik", {hardening_of(Ludwik{20., 500., .2}), general_mises()}, true);
      add("Hill 1948 r = .6, Swift", {hardening_of(swift), normal_anisotropy(.6)}, false);
      add("Hill 1948 r = 2, Voce", {hardening_of(voce), normal_anisotropy(2.)}, false);
      add("Hill 1948 with three r", {hardening_of(swift), std::make_unique<Hill48>(1.79, 1.51, 2.27)}, false);
      add("quartic",
          {hardening_of(swift), std::make_unique<Quartic>(make_mises(), std::make_unique<Hill48>(3., 2., 1.5))},
          false);
      add("plane stress only",
          {hardening_of(swift), std::make_unique<PlaneStressOnly>(normal_anisotropy(1.4))},
          false);
      for (const std::string law : {"hill", "hosford"}) // in the axes of a solid's section
        for (const double r : {.5, 2.})
        {
          std::vector<std::string> entries = {"r-bar=" + std::to_string(r)};
          if (law == "hosford")
            entries.emplace_back("Exponent=6");
          ParameterTree tree = ParameterTree::parse("", "test", entries);
          Section section = tree.root();
          add(law + " in a section, r = " + std::to_string(r),
              {hardening_of(swift), Registry<YieldSurface>::make(law, section)->in_section()},
              false);
        }
      add("Mises, Chaboche", {hardening_of(voce), make_mises(), chaboche()}, true);
      add("Hill 1948, Chaboche", {hardening_of(swift), normal_anisotropy(.6), chaboche()}, false);
      add("Mises, rate and heat", {hardening_of(swift), make_mises(), nullptr, rate()}, true);
      add("Hill 1948, Chaboche, rate and heat", {hardening_of(voce), normal_anisotropy(2.), chaboche(), rate()}, false);
    }

    /// Every yield surface with every backstress and every rate factor, each with a hardening law in turn, all of drawn
    /// parameters.
    inline void add_combinations(std::vector<MaterialCase> &cases)
    {
      std::mt19937 generator(21);
      const auto hardenings = laws_of_strain();
      unsigned int next = 0;
      for (const auto &yield : Registry<YieldSurface>::names())
        for (const auto &back : Registry<BackStress>::names())
          for (const auto &rate : Registry<RateFactor>::names())
          {
            auto entries = drawn(law_entries<YieldSurface>("Yield surface", yield), generator);
            for (const auto &more : {drawn(law_entries<BackStress>("Backstress", back), generator),
                                     drawn(law_entries<RateFactor>("Rate factor", rate), generator)})
              entries.insert(entries.end(), more.begin(), more.end());
            std::vector<std::string> own;
            const std::string hardening = hardening_for(back, hardenings[next++ % hardenings.size()], own);
            entries.insert(entries.end(), own.begin(), own.end());
            cases.push_back({yield + ", " + hardening + ", " + back + ", " + rate,
                             make_material("elastoplastic", hardening, entries),
                             yield == "mises"});
          }
    }

    /// Every yield surface with every backstress, and heat: flow curves, or a rate factor and a softening in turn, of
    /// drawn parameters. The heat capacity is large: the tests make strains that would melt the metal.
    inline void add_combinations_with_heat(std::vector<MaterialCase> &cases)
    {
      std::mt19937 generator(22);
      const auto rates = Registry<RateFactor>::names(), softenings = Registry<Softening>::names();
      unsigned int next = 0;
      for (const auto &yield : Registry<YieldSurface>::names())
        for (const auto &back : Registry<BackStress>::names())
        {
          std::vector<std::string> entries = {"Material/Heat/Adiabatic=true", "Material/Heat/Heat capacity=3000"};
          std::vector<std::string> fixed; // by the backstress
          const std::string hardening = hardening_for(back, next % 3 == 0 ? "flow curves" : "ludwik", fixed);
          const bool own = hardening == "flow curves";
          const std::string softening = own ? "none" : softenings[next % softenings.size()];
          const std::string rate = own ? "none" : rates[next % rates.size()];
          for (const auto &entry : law_entries<Softening>("Heat", softening))
            if (entry.find("/Law=") == std::string::npos)
              entries.push_back(entry);
          entries.push_back("Material/Heat/Softening=" + softening);
          for (const auto &more : {law_entries<YieldSurface>("Yield surface", yield),
                                   law_entries<BackStress>("Backstress", back),
                                   law_entries<RateFactor>("Rate factor", rate)})
            entries.insert(entries.end(), more.begin(), more.end());
          entries = drawn(entries, generator);
          entries.insert(entries.end(), fixed.begin(), fixed.end());
          cases.push_back({yield + ", " + hardening + ", " + back + ", " + rate + ", heat, " + softening,
                           make_material("elastoplastic", hardening, entries),
                           yield == "mises"});
          ++next;
        }
    }

    /// All materials that the conformance tests ask: registered ones and those that the interfaces have to carry.
    template <typename Body>
    void for_all_cases(const Body &body)
    {
      std::vector<MaterialCase> cases;
      add_registered_cases(cases);
      add_composed_cases(cases);
      add_combinations(cases);
      add_combinations_with_heat(cases);
      for (const auto &one : cases)
        BOOST_TEST_CONTEXT(one.name)
      body(one);
    }

    template <typename Body>
    void for_all_materials(const Body &body)
    {
      for_all_cases([&](const MaterialCase &one) { body(*one.material); });
    }
  } // namespace testing
} // namespace deltaform
