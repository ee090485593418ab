// The force that draws a strip over circles, against closed forms and a program that shares no line with this one.
#include <deltaform/materials/repeated_bending.h>
#include <deltaform/materials/uniaxial_curve.h>
#include <deltaform/parameters/section.h>

#include "material_cases.h"

#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  std::unique_ptr<Material> make(const std::string &kind, std::vector<std::string> entries)
  {
    entries.insert(entries.end(), {"Young's modulus=206e3", "Poisson's ratio=.3"});
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    return Registry<Material>::make(kind, section);
  }

  /// Mild steel of the NUMISHEET'93 U-bend.
  std::unique_ptr<Material> mild_steel()
  {
    return make("elastoplastic", {"Hardening/Law=swift", "Hardening/Strength coefficient=565.32",
                                  "Hardening/Prestrain=.007117", "Hardening/Hardening exponent=.2589"});
  }
} // namespace

BOOST_AUTO_TEST_SUITE(repeated_bending)

BOOST_AUTO_TEST_CASE(three_circles)
{
  // Own program: fibre by fibre, Gauss rule of 100 points, 100 steps a bend.
  const auto law = mild_steel();
  const auto force = [&](const std::vector<double> &radii, const StripThickness change) {
    return drawing_force(*law, .78, radii, change).value();
  };
  const auto close = [](const double a, const double b) { return std::abs(a - b) < 1e-3 * b; };
  BOOST_TEST(close(force({5.39}, StripThickness::stays), 16.281));
  BOOST_TEST(close(force({5.39, 5.39, 5.39}, StripThickness::stays), 61.813));
  BOOST_TEST(std::abs(force({5.39}, StripThickness::follows) - 16.198) < 2e-3 * 16.198);
  BOOST_TEST(close(force({5.39, 5.39, 5.39}, StripThickness::follows), 59.177));
}

BOOST_AUTO_TEST_CASE(elastic_bending_costs_nothing)
{
  const auto force = drawing_force(*make("linear elastic", {}), .78, {100., 100., 100.}, StripThickness::stays);
  BOOST_TEST_REQUIRE(force.has_value());
  BOOST_TEST(std::abs(*force) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_perfectly_plastic_strip)
{
  // M = M_p (1 - (k_e/k)^2/3) beyond yield at k_e = 2 s'/(E' t), M_p = s' t^2/4, s' = 2 s/sqrt 3; back by twice that
  // curve at half the curvature: bending and straightening take M_p (2/R - 5 k_e). The tension's stretch is small.
  const auto law = make("elastoplastic", {"Hardening/Law=perfectly plastic", "Hardening/Flow stress=200"});
  const double flow = 200. * 2. / std::sqrt(3.), first_yield = 2. * flow * (1. - .09) / 206e3;
  const double work = flow / 4. * (2. / 20. - 5. * first_yield);
  const auto force = drawing_force(*law, 1., {20.}, StripThickness::stays);
  BOOST_TEST_REQUIRE(force.has_value());
  BOOST_TEST(std::abs(*force - work) < 1e-2 * work);
}

BOOST_AUTO_TEST_CASE(a_strip_that_tears)
{
  // Each pass over a circle of the plastic sheet adds tension until the section carries no more.
  const auto law = make("elastoplastic", {"Hardening/Law=perfectly plastic", "Hardening/Flow stress=200"});
  BOOST_TEST(!drawing_force(*law, 1., std::vector<double>(20, 1.)).has_value());
}

BOOST_AUTO_TEST_CASE(modulus_in_tension)
{
  // ds/de = H E/(E + H), H = n K (e0 + e_p)^(n - 1).
  const auto curve = uniaxial_curve(*mild_steel());
  BOOST_TEST(curve.size() > 50);
  for (const double strain : {.01, .1, .4})
  {
    const double h = .2589 * 565.32 * std::pow(.007117 + strain, .2589 - 1.);
    BOOST_TEST(std::abs(tangent_modulus(curve, strain) - h * 206e3 / (206e3 + h)) < .01 * h);
  }
  BOOST_TEST(tangent_modulus(curve, 0.) == curve.front().modulus);
  BOOST_TEST(std::abs(curve.front().modulus - 206e3) < 1e-6 * 206e3);
}

BOOST_AUTO_TEST_SUITE_END()
