#include <deltaform/increment/step_control.h>
#include <deltaform/increment/target_search.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/section.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>

using namespace deltaform;

namespace
{
  constexpr unsigned int least = 5;

  struct Outcome
  {
    TargetSearch search;
    double iterations; ///< of the whole way
    double mean_target; ///< of the last two hundred increments
  };


  /// A process of so many increments, in each of which the length is such that it takes what is aimed at. @param length
  /// that takes a number of iterations, at a share of the way
  Outcome run(const std::function<double(double iterations, double share)> &length, const unsigned int increments)
  {
    Outcome result{{}, 0., 0.};
    for (unsigned int k = 0; k < increments; ++k)
    {
      const unsigned int target = result.search.target(least);
      result.search.accept(length(target, static_cast<double>(k) / increments), target);
      result.iterations += target;
      if (k + 200 >= increments)
        result.mean_target += target / 200.;
    }
    return result;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(target_search)

BOOST_AUTO_TEST_CASE(longer_increments_where_they_are_cheap)
{
  // Twice the length takes 1.4 times the iterations: up to three more than asked for.
  const auto outcome = run([](const double n, double) { return n * n; }, 800);
  BOOST_TEST(outcome.mean_target > least + 2.3);
  BOOST_TEST(outcome.mean_target <= least + 3.);
}

BOOST_AUTO_TEST_CASE(not_where_they_are_dear)
{
  const auto outcome = run([](const double n, double) { return std::sqrt(n); }, 800);
  BOOST_TEST(outcome.mean_target < least + .7); // it looks whether one more has become better
}

BOOST_AUTO_TEST_CASE(a_process_that_gets_harder_is_no_reason)
{
  // The length that an iteration is worth falls to a tenth; one that gets easier rises tenfold.
  for (const double change : {.1, 10.})
  {
    const auto dear =
      run([&](const double n, const double share) { return std::sqrt(n) * std::pow(change, share); }, 800);
    BOOST_TEST(dear.mean_target < least + .7);
    const auto cheap = run([&](const double n, const double share) { return n * n * std::pow(change, share); }, 800);
    BOOST_TEST(cheap.mean_target > least + 2.3);
  }
}

BOOST_AUTO_TEST_CASE(it_finds_what_is_best_between)
{
  const auto outcome = run([](const double n, double) { return n / (1. + .1 * std::pow(n - 6., 2)); }, 800);
  BOOST_TEST(outcome.mean_target == 6., boost::test_tools::tolerance(.1));
}

BOOST_AUTO_TEST_CASE(short_runs_keep_what_is_asked_for)
{
  TargetSearch search;
  for (unsigned int k = 0; k < 20; ++k)
  {
    BOOST_TEST(search.target(least) == least);
    search.accept(1., least);
  }
  BOOST_TEST(search.target(least) == least + 1u);
}

BOOST_AUTO_TEST_CASE(the_step_control_makes_use_of_it)
{
  // Iterations rise with the square root of the length.
  ParameterTree tree = ParameterTree::parse("", "test", {"Target iterations=5"});
  Section section = tree.root();
  const StepSettings settings(section);
  StepControl control(settings, 0., 1e6, 1., 1e-6, 1e6, {});
  double length = 1.;
  for (unsigned int k = 0; k < 600; ++k)
  {
    length = control.increment();
    const auto iterations = static_cast<unsigned int>(std::lround(std::sqrt(length)));
    control.accept(iterations, 0., std::numeric_limits<double>::infinity(), iterations);
    if (k == 300) // a run that is resumed goes on with it
    {
      const auto state = control.state();
      StepControl again(settings, 0., 1e6, 1., 1e-6, 1e6, {});
      again.restore(state);
      BOOST_TEST(again.state().search.target(5) == state.search.target(5));
      BOOST_TEST(state.search.target(5) > 5u);
    }
  }
  BOOST_TEST(length > 6. * 6.);
}

BOOST_AUTO_TEST_SUITE_END()
