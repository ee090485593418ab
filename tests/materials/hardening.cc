// The hardening laws at figures worked out apart from the code (decimal arithmetic of 40 digits).
#include "material_point.h"

#include <deltaform/materials/hardening_laws.h>
#include <deltaform/materials/read_law.h>
#include <deltaform/parameters/scene_error.h>

using namespace deltaform;
using testing::make_hardening;

namespace
{
  void check(const FlowStress flow, const double value, const double slope)
  {
    BOOST_TEST(std::abs(flow.value - value) <= 1e-14 * value);
    BOOST_TEST(std::abs(flow.slope - slope) <= 1e-13 * std::abs(slope));
  }

  bool names_the_entry(const SceneError &error)
  {
    return std::string(error.what()).find("Flow curve") != std::string::npos;
  }

  bool names_saturation_stress(const SceneError &error)
  {
    return std::string(error.what()).find("Saturation stress") != std::string::npos;
  }

  constexpr double infinity = std::numeric_limits<double>::infinity();

  /// A law by its value, and by its name with the same numbers; its table has the documented ones.
  template <typename Law>
  void check_value(const std::string &name, const Law &law, const std::vector<std::string> &entries)
  {
    BOOST_TEST_CONTEXT(name)
    {
      const auto named = make_hardening(name, entries), documented = make_hardening(name);
      const Law example = Law::parameters().example();
      BOOST_CHECK_NO_THROW(Law::parameters().check(law));
      BOOST_CHECK_NO_THROW(Law::parameters().check(example));
      for (const double e : {0., 1e-9, .07, .6})
      {
        BOOST_TEST(law(e).value == named->evaluate(e).value);
        BOOST_TEST(law(e).slope == named->evaluate(e).slope);
        BOOST_TEST(example(e).value == documented->evaluate(e).value);
      }
    }
  }
} // namespace

BOOST_AUTO_TEST_SUITE(hardening)

BOOST_AUTO_TEST_CASE(values)
{
  {
    const auto law = make_hardening("perfectly plastic", {"Flow stress=200"});
    check(law->evaluate(1e-9), 200.0, 0.0);
    check(law->evaluate(0.07), 200.0, 0.0);
    check(law->evaluate(0.6), 200.0, 0.0);
  }
  {
    const auto law = make_hardening("linear", {"Initial flow stress=200", "Hardening modulus=300"});
    check(law->evaluate(1e-9), 200.0000003, 300.0);
    check(law->evaluate(0.07), 221.0, 300.0);
    check(law->evaluate(0.6), 380.0, 300.0);
  }
  {
    const auto law =
      make_hardening("ludwik", {"Initial flow stress=194", "Strength coefficient=550.4", "Hardening exponent=.223"});
    check(law->evaluate(1e-9), 199.41599712610928, 1207767359.1223695);
    check(law->evaluate(0.07), 498.18324468678053, 969.04090807360084);
    check(law->evaluate(0.6), 685.14095918970358, 182.5407231655065);
  }
  {
    const auto law = make_hardening("swift", {"Strength coefficient=589", "Prestrain=1e-4", "Hardening exponent=.216"});
    check(law->evaluate(1e-9), 80.559401834845512, 174006.56789758733);
    check(law->evaluate(0.07), 331.73430650348673, 1022.1770357311431);
    check(law->evaluate(0.6), 527.48680241484768, 189.8636049351893);
  }
  {
    const auto law = make_hardening(
      "voce", {"Initial flow stress=450", "Saturation stress=715", "Saturation rate=16.93", "Linear modulus=129.24"});
    check(law->evaluate(1e-9), 450.00000461568996, 4615.6899240444021);
    check(law->evaluate(0.07), 643.03216430149791, 1500.8177823756403);
    check(law->evaluate(0.6), 792.53372734916579, 129.41391597862312);
  }
  {
    const auto law = make_hardening(
      "hockett-sherby",
      {"Initial flow stress=120", "Saturation stress=380", "Saturation rate=5", "Hardening exponent=.75"});
    check(law->evaluate(1e-9), 120.00023117622053, 173382.08831782758);
    check(law->evaluate(0.07), 248.3382891539602, 959.87847278166779);
    check(law->evaluate(0.6), 371.39775228247595, 36.652651694256254);
  }
  {
    const auto law = make_hardening("two-branch power",
                                    {"Initial flow stress=5.4",
                                     "First coefficient=27.8",
                                     "First exponent=.504",
                                     "Second coefficient=24.4",
                                     "Second exponent=.375"});
    check(law->evaluate(1e-9), 5.4008091793588225, 407826.39684654821);
    check(law->evaluate(0.07), 12.677365843761309, 52.397034075081428);
    check(law->evaluate(0.6), 25.546357914324223, 12.591473696452639);
  }
}

BOOST_AUTO_TEST_CASE(values_without_a_scene)
{
  check_value("perfectly plastic", PerfectlyPlastic{230.}, {"Flow stress=230"});
  check_value("linear", LinearHardening{230., 310.}, {"Initial flow stress=230", "Hardening modulus=310"});
  check_value("ludwik",
              Ludwik{190., 510., .3},
              {"Initial flow stress=190", "Strength coefficient=510", "Hardening exponent=.3"});
  check_value(
    "swift", Swift{510., 2e-4, .3}, {"Strength coefficient=510", "Prestrain=2e-4", "Hardening exponent=.3"});
  check_value("voce",
              Voce{400., 700., 12.},
              {"Initial flow stress=400", "Saturation stress=700", "Saturation rate=12"});
  check_value("hockett-sherby",
              HockettSherby{100., 400., 6., .7},
              {"Initial flow stress=100", "Saturation stress=400", "Saturation rate=6", "Hardening exponent=.7"});
  check(TwoBranchPower(5.4, {27.8, .504}, {24.4, .375})(.6), 25.546357914324223, 12.591473696452639);
  check(FlowCurve({{0., 100.}, {.1, 110.}, {.5, 150.}, {2., 300.}})(.037), 103.7, 100.);
}

BOOST_AUTO_TEST_CASE(values_that_make_no_law)
{
  const auto names = [](const std::string &parameter) {
    return [=](const std::invalid_argument &error) { return std::string(error.what()).find(parameter) == 0; };
  };
  BOOST_CHECK_EXCEPTION(
    Swift::parameters().check({589., 1e-4, 1.2}), std::invalid_argument, names("Hardening exponent"));
  BOOST_CHECK_EXCEPTION(Voce::parameters().check({400., 300., 5.}), std::invalid_argument, names("Saturation stress"));
  BOOST_CHECK_THROW(FlowCurve({{0., 100.}, {.1, 90.}, {.2, 200.}, {.3, 300.}}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(slope_at_zero)
{
  BOOST_TEST(make_hardening("ludwik")->evaluate(0.).slope == infinity);
  BOOST_TEST(make_hardening("two-branch power")->evaluate(0.).slope == infinity);
  BOOST_TEST(make_hardening("hockett-sherby")->evaluate(0.).slope == infinity);
  BOOST_TEST(
    make_hardening("swift", {"Strength coefficient=500", "Prestrain=0", "Hardening exponent=.2"})->evaluate(0.).slope ==
    infinity);
  BOOST_TEST(
    make_hardening("swift", {"Strength coefficient=500", "Prestrain=0", "Hardening exponent=1"})->evaluate(0.).slope ==
    500.);
}

BOOST_AUTO_TEST_CASE(two_branches_meet_where_the_benchmark_says)
{
  const auto law = make_hardening("two-branch power");
  const double at = .36375937022652;
  const auto before = law->evaluate(at - 1e-9), after = law->evaluate(at + 1e-9);
  BOOST_TEST(std::abs(before.slope - 23.13724) < 1e-5);
  BOOST_TEST(std::abs(after.slope - 17.21521) < 1e-5);
  BOOST_TEST(std::abs(before.value - after.value) < 1e-7);
}

BOOST_AUTO_TEST_CASE(as_printed_jumps_as_printed)
{
  const auto law = make_hardening("two-branch power",
                                  {"Initial flow stress=5.4",
                                   "First coefficient=27.8",
                                   "First exponent=.504",
                                   "Second coefficient=24.4",
                                   "As printed=true"});
  BOOST_TEST(std::abs(law->evaluate(.36).value - 22.01) < .005);
  BOOST_TEST(std::abs(law->evaluate(std::nextafter(.36, 1.)).value - 19.98) < .005);
}

BOOST_AUTO_TEST_CASE(table_goes_through_its_rows_and_stays_constant_beyond)
{
  const auto law = make_hardening("table", {"Flow curve=0 100; .1 150; .2 150; .5 180; .6 300"});
  check(law->evaluate(0.), 100., 500.);
  check(law->evaluate(.1), 150., 0.);
  check(law->evaluate(.2), 150., 0.);
  BOOST_TEST(law->evaluate(.15).value == 150.);
  BOOST_TEST(std::abs(law->evaluate(.5).value - 180.) < 1e-12);
  check(law->evaluate(.6), 300., 0.);
  check(law->evaluate(7.), 300., 0.);
  double before = 0.;
  for (unsigned int i = 0; i <= 7000; ++i)
  {
    const FlowStress flow = law->evaluate(1e-4 * i);
    BOOST_TEST(flow.value >= before - 1e-12);
    BOOST_TEST(flow.slope >= -1e-9);
    before = flow.value;
  }
  const auto line = make_hardening("table", {"Flow curve=0 100; .1 110; .5 150; 2 300"});
  check(line->evaluate(.037), 103.7, 100.);
  check(line->evaluate(1.23), 223., 100.);
}

BOOST_AUTO_TEST_CASE(bad_tables_name_the_entry)
{
  for (const std::string rows : {"0 100; .1 150; .2 140; .3 160",
                                 "0 100; .1 150; .1 160; .3 170",
                                 "0 100; .2 150; .1 160; .3 170",
                                 "0 0; .1 150; .2 160; .3 170",
                                 "0 -1; .1 150; .2 160; .3 170",
                                 ".1 100; .2 150; .3 160; .4 170",
                                 "0 100; .1 150; .2 160",
                                 "0 100; .1 nan; .2 160; .3 170"})
    BOOST_TEST_CONTEXT(rows)
  BOOST_CHECK_EXCEPTION(make_hardening("table", {"Flow curve=" + rows}), SceneError, names_the_entry);
}

BOOST_AUTO_TEST_CASE(saturation_below_the_initial_flow_stress)
{
  BOOST_CHECK_EXCEPTION(
    make_hardening("voce", {"Initial flow stress=400", "Saturation stress=300", "Saturation rate=10"}),
    SceneError,
    names_saturation_stress);
  BOOST_CHECK_EXCEPTION(
    make_hardening("hockett-sherby",
                   {"Initial flow stress=400", "Saturation stress=300", "Saturation rate=10", "Hardening exponent=.5"}),
    SceneError,
    names_saturation_stress);
}

BOOST_AUTO_TEST_SUITE_END()
