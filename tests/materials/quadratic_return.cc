// The return map of quadratic surfaces is the general one: the same paths by both, with backstresses of its kind and
// every rate factor.
#include "material_cases.h"

#include <deltaform/parameters/section.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  const Elasticity elastic(69004., .3);

  template <typename Kind>
  std::unique_ptr<Kind> law(const std::string &name, const std::vector<std::string> &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    auto result = Registry<Kind>::make(name, section);
    tree.check_unused();
    return result;
  }

  using Surface = std::unique_ptr<YieldSurface>;

  struct NamedSurface
  {
    std::string name;
    std::function<Surface()> make;
  };

  const std::vector<NamedSurface> surfaces = {
    {"mises", [] { return make_mises(); }},
    {"hill", [] { return law<YieldSurface>("hill", {"r-bar=.6"}); }},
    {"hill, rolled along", [] { return law<YieldSurface>("hill", {"r0=1.79", "r90=2.27"}); }},
    {"hill, rolled across", [] { return law<YieldSurface>("hill", {"r0=1.4", "r90=.5", "Rolling direction=across"}); }},
    {"hill, in a section", [] { return law<YieldSurface>("hill", {"r-bar=2.1"})->in_section(); }},
    {"hill with r0 and r90, in a section",
     [] { return law<YieldSurface>("hill", {"r0=1.4", "r90=.5"})->in_section(); }}};

  std::unique_ptr<BackStress> back_stress(const unsigned int n_terms)
  {
    if (n_terms == 0)
      return nullptr;
    if (n_terms == 1)
      return law<BackStress>("linear", {"Hardening modulus=2000"});
    const std::string terms = n_terms == 2 ? "20000 100; 500 0" : "9e4 3000; 9000 90; 0 5; 100 1";
    return law<BackStress>("chaboche", {"Terms=" + terms});
  }

  std::unique_ptr<RateFactor> rate_factor(const std::string &name)
  {
    if (name == "none")
      return nullptr;
    if (name == "heat")
      return std::make_unique<CowperSymondsWithHeat>(40.4, 5., 2e-3, .3);
    if (name == "cowper-symonds")
      return law<RateFactor>(name, {"Reference rate=40", "Rate exponent=5"});
    if (name == "johnson-cook")
      return law<RateFactor>(name, {"Reference rate=.02", "Rate coefficient=.03"});
    return law<RateFactor>(name, {"Overstress=30", "Rate exponent=4"});
  }

  std::unique_ptr<Elastoplastic>
  metal(Surface surface, const unsigned int n_terms, const std::string &rate, const std::string &hardening)
  {
    FlowLaws laws{make_hardening(hardening), std::move(surface), back_stress(n_terms), rate_factor(rate)};
    return std::make_unique<Elastoplastic>(elastic, std::move(laws));
  }

  void check_path(const Material &one, const Material &other, const ThirdDirection third, const double size,
                  const bool two_steps)
  {
    MaterialPoint point(one, two_steps), general(other, two_steps);
    std::mt19937 generator(11);
    for (unsigned int step = 0; step < 12; ++step)
    {
      Mandel e = random_strain(generator, size), e_other = e;
      std::array<double, 16> C{}, D{};
      const double third_stress = step % 3 - 1.;
      const Mandel stress = point.update(e, third, third_stress, C.data());
      const Mandel expected = general.update(e_other, third, third_stress, D.data());
      BOOST_TEST_REQUIRE(point.status.good());
      BOOST_TEST_REQUIRE(general.status.good());
      require_close(stress, expected, 1e-11 * norm(expected) + 1e-12 * elastic.young * size, "the stress");
      require_close(e, e_other, 1e-11 * norm(e), "the strain");
      for (unsigned int i = 0; i < 16; ++i)
        require_close(C[i], D[i], 1e-9 * elastic.young, "the tangent");
      for (unsigned int i = 0; i < point.trial.size(); ++i)
        require_close(point.trial[i], general.trial[i], 1e-10 * (size + std::abs(general.trial[i])), "the history");
      point.commit();
      general.commit();
    }
  }
} // namespace

BOOST_AUTO_TEST_SUITE(quadratic_return)

BOOST_AUTO_TEST_CASE(as_the_general_return_map)
{
  for (const auto &[name, make] : surfaces)
    for (const unsigned int n_terms : {0u, 1u, 2u, 4u})
      for (const std::string rate : {"none", "cowper-symonds", "johnson-cook", "power", "heat"})
        for (const std::string hardening : {"perfectly plastic", "swift", "ludwik"})
        {
          const auto fast = metal(make(), n_terms, rate, hardening);
          const auto slow = metal(std::make_unique<WithoutClosedForm>(make()), n_terms, rate, hardening);
          for (const auto third : {ThirdDirection::strain_given, ThirdDirection::stress_given})
            for (const double size : {1e-3, 3e-2})
              for (const bool two_steps : {false, true})
                BOOST_TEST_CONTEXT(name << ", " << n_terms << " terms, " << rate << ", " << hardening
                                        << (third == ThirdDirection::strain_given ? ", solid" : ", shell")
                                        << ", strain " << size << (two_steps ? ", two steps" : ""))
          check_path(*fast, *slow, third, size, two_steps);
        }
}

// Shells whose modulus falls.
BOOST_AUTO_TEST_CASE(falling_modulus)
{
  for (const auto &[name, make] : surfaces)
  {
    const auto with = [&](Surface surface) {
      FlowLaws laws{make_hardening("swift"), std::move(surface), back_stress(2), nullptr};
      return std::make_unique<Elastoplastic>(elastic, std::move(laws), Elastoplastic::Integration::two_steps,
                                             FallingModulus{50e3, 60.});
    };
    BOOST_TEST_CONTEXT(name)
    check_path(*with(make()), *with(std::make_unique<WithoutClosedForm>(make())), ThirdDirection::stress_given, .03,
               false);
  }
}

BOOST_AUTO_TEST_SUITE_END()
