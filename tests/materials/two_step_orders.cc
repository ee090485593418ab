// Orders of both formulas of flow with everything that a metal remembers: stresses at the end of a path that turns,
// with n, 2 n and 4 n increments.
#include "drawn_metals.h"

#include <deltaform/parameters/section.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  using Entries = std::vector<std::string>;

  constexpr double flow_stress = 300.;

  /// Stretched to the yield stress, then led along a curve within 1 s.
  Mandel stress_at_end(const Material &material, const bool two_steps, const unsigned int n)
  {
    const double yield = flow_stress / (3. * material.shear_modulus()); // equivalent strain
    const auto strain = [&](const double t) {
      const double along = yield + .012 * std::sin(1.2 * t), shear = .02 * t * t;
      return Mandel{{along, -.5 * along, -.5 * along, shear}};
    };
    MaterialPoint point(material, two_steps);
    point.duration = 1.;
    point.solid(strain(0.));
    point.commit();
    point.duration = 1. / n;
    Mandel stress{};
    for (unsigned int k = 1; k <= n; ++k)
    {
      stress = point.solid(strain(static_cast<double>(k) / n));
      BOOST_TEST_REQUIRE(point.status.good());
      point.commit();
    }
    return stress;
  }

  double order(const Material &material, const bool two_steps, const unsigned int n)
  {
    const Mandel one = stress_at_end(material, two_steps, n), two = stress_at_end(material, two_steps, 2 * n),
                 four = stress_at_end(material, two_steps, 4 * n);
    return std::log2(norm(difference(one, two)) / norm(difference(two, four)));
  }

  void check_orders(const std::string &name, Entries entries)
  {
    for (const std::string entry : {"Young's modulus=200e3", "Poisson's ratio=.3"})
      entries.push_back("Material/" + entry);
    const bool own_hardening = std::any_of(entries.begin(), entries.end(), [](const std::string &entry) {
      return entry.rfind("Material/Hardening/Law", 0) == 0;
    });
    if (!own_hardening)
      entries.insert(entries.end(), {"Material/Hardening/Law=linear",
                                     "Material/Hardening/Initial flow stress=300",
                                     "Material/Hardening/Hardening modulus=1000"});
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root().sub("Material");
    const auto material = Registry<Material>::make("elastoplastic", section);
    const double first = order(*material, false, 160), second = order(*material, true, 160);
    BOOST_TEST_MESSAGE(name << ": backward Euler " << first << ", two steps " << second);
    BOOST_TEST(std::abs(first - 1.) < .02, name << ": backward Euler is of order " << first);
    BOOST_TEST(std::abs(second - 2.) < .05, name << ": two steps are of order " << second);
  }

  const Entries heat = {"Material/Heat/Adiabatic=true", "Material/Heat/Heat capacity=.3"};
} // namespace

BOOST_AUTO_TEST_SUITE(two_step_orders)

BOOST_AUTO_TEST_CASE(hardening)
{
  check_orders("linear hardening", {});
}

BOOST_AUTO_TEST_CASE(backstress)
{
  check_orders("Chaboche", {"Material/Backstress/Law=chaboche", "Material/Backstress/Terms=20000 100; 2000 0"});
  check_orders("Yoshida and Uemori",
               {"Material/Hardening/Law=perfectly plastic",
                "Material/Hardening/Flow stress=300",
                "Material/Backstress/Law=yoshida-uemori",
                "Material/Backstress/Yield stress=300",
                "Material/Backstress/Bounding stress=420",
                "Material/Backstress/Yield surface rate=100",
                "Material/Backstress/Bounding surface rate=20",
                "Material/Backstress/Bounding backstress=80",
                "Material/Backstress/Stagnation=.5",
                "Material/Backstress/Saturation stress=190"});
}

BOOST_AUTO_TEST_CASE(yield_surfaces)
{
  check_orders("Hill", {"Material/Yield surface/Law=hill", "Material/Yield surface/r-bar=1.6"});
  check_orders("Logan and Hosford",
               {"Material/Yield surface/Law=hosford", "Material/Yield surface/Exponent=6",
                "Material/Yield surface/r-bar=1."});
}

BOOST_AUTO_TEST_CASE(rate)
{
  check_orders("Cowper and Symonds",
               {"Material/Rate factor/Law=cowper-symonds", "Material/Rate factor/Reference rate=10",
                "Material/Rate factor/Rate exponent=5"});
  check_orders("power overstress",
               {"Material/Rate factor/Law=power", "Material/Rate factor/Overstress=100",
                "Material/Rate factor/Rate exponent=2"});
}

BOOST_AUTO_TEST_CASE(softening_by_heat)
{
  Entries entries = heat;
  entries.insert(entries.end(), {"Material/Heat/Softening=johnson-cook",
                                 "Material/Heat/Softening exponent=1.09",
                                 "Material/Heat/Initial temperature=298",
                                 "Material/Heat/Melting temperature=1356"});
  check_orders("Johnson and Cook's softening", entries);
}

BOOST_AUTO_TEST_SUITE_END()
