// Forming limits against closed forms and a program of its own; criteria of points against closed forms.
#include <deltaform/materials/forming_limit.h>
#include <deltaform/materials/point_field.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>

#include "../../source/materials/marciniak_kuczynski.h"
#include "material_cases.h"

#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double n = .2;

  /// K e^n, r = 1, with elastic strains that are next to nothing.
  std::unique_ptr<Material> power_law()
  {
    ParameterTree tree = ParameterTree::parse(
      "", "test",
      {"Young's modulus=1e8", "Poisson's ratio=.3", "Hardening/Law=swift", "Hardening/Strength coefficient=500",
       "Hardening/Prestrain=1e-6", "Hardening/Hardening exponent=.2", "Integration=backward Euler"});
    Section section = tree.root();
    return Registry<Material>::make("elastoplastic", section);
  }

  std::unique_ptr<FormingLimit> read(const std::vector<std::string> &entries)
  {
    std::vector<std::string> all;
    for (const auto &entry : entries)
      all.push_back("Limits/forming limit/" + entry);
    ParameterTree tree = ParameterTree::parse("", "test", all);
    return read_forming_limit(tree.root(), *power_law());
  }

  void check_refused(const std::vector<std::string> &entries, const std::string &reason)
  {
    BOOST_CHECK_EXCEPTION(read(entries), SceneError, [&](const SceneError &error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).find(reason) != std::string::npos;
    });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(forming_limits)

BOOST_AUTO_TEST_CASE(plane_strain_of_a_grooved_sheet)
{
  // e1 exp(-e1/n) = f^(1/n) n/e, the maximum of the groove's force: e1 = -n W0(-f^(1/n)/e).
  const auto law = power_law();
  for (const auto &[groove, closed] :
       std::vector<std::pair<double, double>>{{.98, .12304}, {.99, .14311}, {.995, .15850}})
  {
    const auto limit = GroovedSheet{groove, 0.}.limit(*law, 0.);
    BOOST_TEST_REQUIRE(limit.has_value());
    // At a ratio of ten the groove is a thousandth short of its maximum.
    BOOST_CHECK_SMALL(limit->major - closed, 1e-3);
    BOOST_CHECK(limit->major < closed);
  }
}

BOOST_AUTO_TEST_CASE(stretched_grooved_sheet)
{
  // Rigid-plastic sheet, Mises, f = .99, groove ten times as fast; an independent program, to the digits shown.
  const auto law = power_law();
  for (const auto &[ratio, major] :
       std::vector<std::pair<double, double>>{{.1, .1445}, {.25, .1817}, {.5, .2861}, {.75, .3969}, {1., .4904}})
  {
    const auto limit = GroovedSheet{.99, 0.}.least_limit(*law, ratio);
    BOOST_TEST_REQUIRE(limit.has_value());
    BOOST_CHECK_SMALL(limit->major - major, 5e-4);
    BOOST_CHECK_SMALL(limit->minor - ratio * limit->major, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(drawn_grooved_sheet)
{
  // The groove turns; an independent program, at an infinite ratio.
  const auto law = power_law();
  for (const auto &[ratio, major] :
       std::vector<std::pair<double, double>>{{-.1, .1570}, {-.25, .1864}, {-.4, .2284}, {-.5, .267}})
  {
    const auto limit = GroovedSheet{.99, 0.}.least_limit(*law, ratio);
    BOOST_TEST_REQUIRE(limit.has_value());
    BOOST_CHECK_SMALL(limit->major - major, 2e-3);
  }
}

BOOST_AUTO_TEST_CASE(curve_along_paths)
{
  const FormingLimit limit({{-.2, .45}, {0., .25}, {.3, .4}});
  BOOST_CHECK_CLOSE(limit.major(-.1), .35, 1e-10);
  BOOST_CHECK_CLOSE(limit.major(-.4), .65, 1e-10); // goes on to the left
  BOOST_CHECK_CLOSE(limit.major(.5), .4, 1e-10); // and is constant to the right
  BOOST_CHECK_CLOSE(limit.along(0.), .25, 1e-10);
  BOOST_CHECK_CLOSE(limit.along(.5), .25 / .75, 1e-10); // .25 + .5 (e/2) = e
  BOOST_CHECK_CLOSE(limit.along(1.), .4, 1e-10);
  BOOST_CHECK_CLOSE(limit.along(-.5), .5, 1e-10); // .25 + e/2 = e, beyond the first point
  BOOST_CHECK(std::isinf(limit.along(-1.)));
  BOOST_CHECK(std::isinf(limit.along(-2.)));
}

BOOST_AUTO_TEST_CASE(keeler_brazier)
{
  // FLC0 = 23.3 + 14.13 t percent at n = .21.
  const auto limit = read({"Curve=keeler-brazier", "Sheet thickness=1", "Hardening exponent=.3"});
  const double plane_strain = std::log(1.3743);
  BOOST_CHECK_CLOSE(limit->major(0.), plane_strain, 1e-10);
  BOOST_CHECK_CLOSE(limit->major(-.2), plane_strain + .2, 1e-10);
  BOOST_CHECK_CLOSE(limit->major(.1), plane_strain + .1 * std::tan(20. * M_PI / 180.), 1e-10);
}

BOOST_AUTO_TEST_CASE(no_curves)
{
  check_refused({"Curve=points", "Points=0 .2; 0 .3"}, "no function");
  check_refused({"Curve=points", "Points=0 .2; -.1 .3"}, "no function");
  check_refused({"Curve=points", "Points=.1 .05"}, "no less than the minor");
  check_refused({"Curve=points", "Points=-.1 -.05"}, "must be positive");
  check_refused({"Curve=marciniak-kuczynski", "Groove=1"}, "Groove");
}

BOOST_AUTO_TEST_CASE(growth_of_criteria)
{
  ParameterTree tree = ParameterTree::parse(
    "", "test", {"Limits/forming limit/Curve=points", "Limits/forming limit/Points=-.2 .45; 0 .25; .3 .4"});
  const auto law = power_law();
  const auto growth = [&](const std::string &name, const PointStep &step) {
    Section section = tree.root().sub("Limits").sub(name);
    return PointFields::make(name, section, PointFieldHost{*law, true})->growth(step);
  };
  // Tension s, strains 1, -1/2, -1/2 of .02; then equal tensions, strains 1, 1, -2 of .01.
  const PointStep bar{{{100., 0., 0., 0.}}, {{120., 0., 0., 0.}}, {{.02, -.01, -.01, 0.}}, .02};
  const PointStep sheet{{{100., 100., 0., 0.}}, {{120., 120., 0., 0.}}, {{.01, .01, -.02, 0.}}, .02};
  BOOST_CHECK_CLOSE(growth("cockcroft-latham", bar), 110. * .02, 1e-10);
  BOOST_CHECK_CLOSE(growth("rice-tracey", bar), std::exp(.5) * .02, 1e-10);
  BOOST_CHECK_CLOSE(growth("rice-tracey", sheet), std::exp(1.) * .02, 1e-10);
  BOOST_CHECK_CLOSE(growth("thinning", sheet), .02, 1e-10);
  BOOST_CHECK_CLOSE(growth("forming limit", bar), .02 / .5, 1e-10);
  BOOST_CHECK_CLOSE(growth("forming limit", sheet), .01 / .4, 1e-10);
  // Compression and shear: the largest principal stress is what counts, and only as a tension.
  const PointStep pressed{{{-100., 0., -50., 0.}}, {{-100., 0., -50., 0.}}, {{-.01, .01, 0., 0.}}, .01};
  BOOST_CHECK_EQUAL(growth("cockcroft-latham", pressed), 0.);
  const PointStep sheared{
    {{0., 0., 0., 80. * std::sqrt(2.)}}, {{0., 0., 0., 80. * std::sqrt(2.)}}, {{0., 0., 0., .01}}, .01};
  BOOST_CHECK_CLOSE(growth("cockcroft-latham", sheared), .8, 1e-10);
  BOOST_CHECK_CLOSE(growth("rice-tracey", sheared), .01, 1e-10);
}

BOOST_AUTO_TEST_SUITE_END()
