// What every registered hardening law has to fulfil, whatever it is called.
#include "material_cases.h"

using namespace deltaform;

namespace
{
  /// Strains over many orders of magnitude, none of them round.
  std::vector<double> sample_strains()
  {
    std::vector<double> result;
    for (double e = 1.2345e-12; e < 5.; e *= 1.37)
      result.push_back(e);
    return result;
  }

  template <typename Body>
  void for_all_laws(const Body &body)
  {
    for (const auto &name : Registry<Hardening>::names())
      BOOST_TEST_CONTEXT(name)
      {
        body(*testing::make_hardening(name));
        BOOST_TEST_CONTEXT("other parameters")
        body(*testing::make_hardening(name, testing::other_hardening_entries(name)));
      }
  }
} // namespace

BOOST_AUTO_TEST_SUITE(hardening_conformance)

BOOST_AUTO_TEST_CASE(there_are_laws)
{
  BOOST_TEST(Registry<Hardening>::names().size() >= 8);
}

BOOST_AUTO_TEST_CASE(positive_and_never_under_the_initial_value)
{
  for_all_laws(
    [](const Hardening &law) {
      const double initial = law.evaluate(0.).value;
      BOOST_TEST_REQUIRE(initial >= 0.);
      BOOST_TEST_REQUIRE(law.evaluate(0.).slope >= 0.);
      for (const double e : sample_strains())
        BOOST_TEST_CONTEXT("at " << e)
        {
          const FlowStress flow = law.evaluate(e);
          BOOST_TEST_REQUIRE(flow.value > 0.);
          BOOST_TEST_REQUIRE(flow.value >= initial);
          BOOST_TEST_REQUIRE(std::isfinite(flow.value));
          BOOST_TEST_REQUIRE(std::isfinite(flow.slope));
        }
    });
}

BOOST_AUTO_TEST_CASE(slope_is_the_derivative)
{
  for_all_laws(
    [](const Hardening &law) {
      for (const double e : sample_strains())
      {
        const double h = 1e-3 * e;
        const auto difference = [&](const double step) {
          return (law.evaluate(e + step).value - law.evaluate(e - step).value) / (2. * step);
        };
        const double numerical = (4. * difference(h / 2.) - difference(h)) / 3.;
        const FlowStress flow = law.evaluate(e);
        BOOST_TEST_CONTEXT("at " << e)
        testing::require_close(
          flow.slope, numerical, 1e-6 * std::abs(flow.slope) + 1e-13 * flow.value / h, "the slope, by differences,");
      }
    });
}

BOOST_AUTO_TEST_CASE(continuous)
{
  for_all_laws(
    [](const Hardening &law) {
      // A jump shows as a rise over one step that halving the step does not halve.
      const unsigned int n_steps = 1 << 20;
      double before = law.evaluate(0.).value;
      for (unsigned int i = 1; i <= n_steps; ++i)
      {
        const double e = 2. * i / n_steps;
        const double here = law.evaluate(e).value;
        if (std::abs(here - before) > 1e-4 * here && i > 1)
        {
          double left = e - 2. / n_steps, right = e;
          for (unsigned int k = 0; k < 30; ++k)
          {
            const double middle = (left + right) / 2.;
            const double value = law.evaluate(middle).value;
            if (std::abs(value - law.evaluate(left).value) > std::abs(law.evaluate(right).value - value))
              right = middle;
            else
              left = middle;
          }
          testing::require_close(law.evaluate(right).value,
                                 law.evaluate(left).value,
                                 1e-6 * here,
                                 "beyond a jump at " + std::to_string(right) + " the flow stress");
        }
        before = here;
      }
      // At zero: even K e^n with a small n comes down to the initial value.
      BOOST_TEST_REQUIRE(law.evaluate(1e-300).value <= (1. + 1e-6) * law.evaluate(0.).value + 1e-6);
    });
}

BOOST_AUTO_TEST_SUITE_END()
