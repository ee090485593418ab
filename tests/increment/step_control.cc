#include <deltaform/increment/step_control.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/section.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>

using namespace deltaform;

namespace
{
  StepSettings settings(const std::vector<std::string> &entries = {})
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    return StepSettings(section);
  }

  /// Of @p n increments that take @p iterations; what is longer than @p longest fails.
  unsigned int
  failures(StepControl &control, const unsigned int n, const double longest, const unsigned int iterations)
  {
    unsigned int result = 0;
    for (unsigned int k = 0; k < n; ++k)
    {
      for (; control.increment() > longest; ++result)
        control.reject(control.increment());
      control.accept(iterations);
    }
    return result;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(step_control)

BOOST_AUTO_TEST_CASE(times_that_must_be_met)
{
  const StepSettings what = settings();
  StepControl control(what, 1., 3., .1, 1e-3, .3, {.5, 1., 1.55, 2.2, 3., 7.}); // those outside do not count
  std::vector<double> times;
  double time = 1.;
  while (!control.finished(time))
  {
    const double next = control.next(time);
    BOOST_TEST_REQUIRE(next > time);
    BOOST_TEST(next - time <= .3 * (1. + 1e-9));
    time = next;
    times.push_back(time);
    control.accept(8);
    BOOST_TEST_REQUIRE(times.size() < 100u);
  }
  BOOST_TEST(time == 3.);
  for (const double wanted : {1.55, 2.2, 3.})
    BOOST_TEST((std::find(times.begin(), times.end(), wanted) != times.end())); // exactly
}

BOOST_AUTO_TEST_CASE(no_slivers)
{
  const StepSettings what = settings();
  const StepControl control(what, 0., 1., .3, 1e-3, .3, {});
  BOOST_TEST(control.next(0.) == .3);
  BOOST_TEST(std::abs(control.next(.6) - .8) < 1e-15); // two equal increments instead of .3 and .1
  BOOST_TEST(control.next(.8) == 1.);
  BOOST_TEST(control.next(1. - .3 * (1. + 1e-12)) == 1.);
}

BOOST_AUTO_TEST_CASE(easy_increments_grow_and_hard_ones_shrink)
{
  const StepSettings what = settings({"Target iterations=8", "Growth=1.5", "Shrink=.5"});
  const auto after = [&](const unsigned int iterations) {
    StepControl control(what, 0., 1., .01, 1e-3, .1, {});
    control.accept(iterations);
    return control.increment();
  };
  BOOST_TEST(after(8) == .01);
  BOOST_TEST(std::abs(after(7) - .01 * std::sqrt(8. / 7.)) < 1e-15);
  BOOST_TEST(after(1) == .015);
  BOOST_TEST(after(0) == .015);
  BOOST_TEST(std::abs(after(16) - .01 * std::sqrt(.5)) < 1e-15);
  BOOST_TEST(after(1000) == .005);

  StepControl control(what, 0., 1., .01, 1e-3, .1, {});
  for (unsigned int k = 0; k < 20; ++k)
    control.accept(1);
  BOOST_TEST(control.increment() == .1);
  for (unsigned int k = 0; k < 20; ++k)
    control.accept(100 - k); // fewer from time to time: it helps
  BOOST_TEST(control.increment() == 1e-3);
}

BOOST_AUTO_TEST_CASE(failures_cut_back)
{
  const StepSettings what = settings({"Shrink=.5", "Growth=1.5"});
  StepControl control(what, 0., 1., .08, .01, .1, {});
  BOOST_TEST(control.reject(.08));
  BOOST_TEST(control.increment() == .04);
  // What was tried counts, not what was planned: the end of a stage may have been nearer.
  BOOST_TEST(control.reject(.03));
  BOOST_TEST(control.increment() == .015);
  // After a failure the first success does not make it grow.
  control.accept(1);
  BOOST_TEST(control.increment() == .015);
  control.accept(1);
  BOOST_TEST(std::abs(control.increment() - .0225) < 1e-15);
  BOOST_TEST(control.reject(.02));
  // Two cuts, or an increment that cannot be cut: not its length is the reason.
  BOOST_TEST((control.effort(.02, 0, true) == Effort::first));
  BOOST_TEST((control.effort(.02, 0, false) == Effort::usual));
  BOOST_TEST((control.effort(.02, 1, true) == Effort::usual));
  BOOST_TEST((control.effort(.02, 2, true) == Effort::last_resorts));
  BOOST_TEST((control.effort(.019, 0, true) == Effort::all));
  // At the smallest increment longer ones are tried, up to the largest one, that once, and then no more.
  for (const double expected : {.05, .1})
  {
    BOOST_TEST(control.reject(.1 * expected));
    BOOST_TEST(std::abs(control.increment() - expected) < 1e-15);
    BOOST_TEST((control.effort(expected, 1, true) == Effort::last_resorts));
  }
  BOOST_TEST(!control.reject(.1));
}

BOOST_AUTO_TEST_CASE(an_increment_that_creeps_has_last_resorts_at_once)
{
  // A thousandth of a usual increment, which is .013 of the stage.
  const StepSettings what = settings({});
  const StepControl control(what, 0., 2., .01, 1e-9, .1, {});
  BOOST_TEST((control.effort(2.7e-5, 0, true) == Effort::first));
  BOOST_TEST((control.effort(2.5e-5, 0, true) == Effort::last_resorts));
  const StepControl shorter(what, 0., 2., .01, 1e-9, .002, {});
  BOOST_TEST((shorter.effort(2.5e-5, 0, true) == Effort::first));
}

BOOST_AUTO_TEST_CASE(cuts_that_did_not_help_are_taken_back)
{
  const StepSettings what = settings({"Shrink=.5", "Growth=1.5"});
  StepControl control(what, 0., 1., .08, 1e-6, .1, {});
  BOOST_TEST(control.reject(.08));
  BOOST_TEST(control.reject(.04));
  BOOST_TEST((control.effort(.02, 2, true) == Effort::last_resorts));
  control.accept(std::nullopt);
  BOOST_TEST(control.increment() == .1); // 1.5 * .08, but no more than the largest
  // Increments that all need a last resort do not become ever shorter.
  StepControl again(what, 0., 1., .001, 1e-6, .1, {});
  for (unsigned int k = 0; k < 3; ++k)
  {
    again.reject(again.increment());
    again.reject(again.increment());
    again.accept(std::nullopt);
  }
  BOOST_TEST(std::abs(again.increment() - .001 * 1.5 * 1.5 * 1.5) < 1e-15);
  // What it strained counts.
  again.accept(std::nullopt, 0., 1e-3);
  BOOST_TEST(std::abs(again.increment() - .8e-3) < 1e-15);
}

BOOST_AUTO_TEST_CASE(shorter_increments_that_do_not_help_stay)
{
  const StepSettings what = settings();
  StepControl control(what, 0., 10., 1., 1e-3, 2., {});
  control.accept(32);
  const double shorter = control.increment();
  BOOST_TEST(shorter < 1.);
  // As many iterations again: it stays, however often.
  for (unsigned int k = 0; k < 5; ++k)
    control.accept(32);
  BOOST_TEST(control.increment() == shorter);
  // Fewer, and still too many: shorter increments help.
  control.accept(20);
  BOOST_TEST(control.increment() < shorter);
  const double help = control.increment();
  control.accept(2);
  BOOST_TEST(control.increment() > help);
}

BOOST_AUTO_TEST_CASE(far_too_short_increments_grow_whatever_they_take)
{
  const StepSettings what = settings();
  StepControl control(what, 0., 1e3, 1e-3, 1e-6, 2., {});
  control.accept(32);
  BOOST_TEST(control.increment() == 1.5e-3);
  for (unsigned int k = 0; k < 20; ++k)
    control.accept(32 + k);
  // Up to a hundredth of a usual one; from there on more iterations make them shorter.
  BOOST_TEST(control.increment() < 1.5 * .02);
  BOOST_TEST(control.increment() > .5 * .02);
}

BOOST_AUTO_TEST_CASE(what_is_short_does_not_depend_on_what_a_scene_allows)
{
  // A stage that may be done at once: increments that are not far too short for any other one wait with lengths that
  // fail, and are made shorter by their iterations.
  const StepSettings what = settings();
  std::array<StepControl, 2> controls{
    {{what, 0., 1., 1e-4, 1e-7, StepControl::usual_share, {}}, {what, 0., 1., 1e-4, 1e-7, 1., {}}}};
  for (unsigned int k = 0; k < 200; ++k)
    for (StepControl &control : controls)
    {
      while (control.increment() > 3e-4)
        control.reject(control.increment());
      control.accept(k % 7 == 0 ? 30 : 4);
      BOOST_TEST(control.increment() == controls[0].increment());
    }
}

BOOST_AUTO_TEST_CASE(a_length_that_fails_is_tried_less_and_less_often)
{
  const StepSettings what = settings();
  StepControl control(what, 0., 1e3, 1e-3, 1e-6, 2., {});
  // Whatever is longer than a third of what would always grow fails.
  const double longest = 6e-3;
  const unsigned int few_iterations = 10;
  BOOST_TEST(failures(control, 500, longest, few_iterations) < 20u);
  // Between two failures it is as long as the last one that did not fail, not half of the one that did.
  BOOST_TEST(failures(control, 20, longest, few_iterations) <= 1u);
  BOOST_TEST(control.increment() > longest / 1.5);
  // Where longer ones do not fail any more they are found.
  BOOST_TEST(failures(control, 100, 1., few_iterations) == 0u);
  BOOST_TEST(control.increment() > .02);
}

BOOST_AUTO_TEST_CASE(increments_that_are_short_and_dear_do_not_wait)
{
  const StepSettings what = settings();
  StepControl control(what, 0., 1e3, 1e-3, 1e-6, 2., {});
  const double longest = 6e-3;
  // Each would take more than twice the iterations that are aimed at: one in three or four is followed by a failure.
  BOOST_TEST(failures(control, 500, longest, 11) > 100u);
  // Long ones wait, whatever they take.
  StepControl longer(what, 0., 1e3, .1, 1e-6, 2., {});
  BOOST_TEST(failures(longer, 500, .1, 11) < 20u);
}

BOOST_AUTO_TEST_CASE(increments_that_crawl_do_not_wait)
{
  // At first what is longer than a hundred thousandth of the largest increment fails, as in a neck; then nothing does.
  const StepSettings what = settings();
  StepControl control(what, 0., 1e3, 1e-3, 1e-6, 2., {});
  for (unsigned int k = 0; k < 100; ++k)
  {
    while (control.increment() > 2e-5)
      control.reject(control.increment());
    control.accept(30);
  }
  for (unsigned int k = 0; k < 14; ++k)
    control.accept(30);
  BOOST_TEST(control.increment() > 2e-3);
}

BOOST_AUTO_TEST_CASE(increments_that_are_nearly_too_large_do_not_grow)
{
  const StepSettings what = settings({"Growth=1.5"});
  StepControl control(what, 0., 10., 1., 1e-2, 5., {});
  control.accept(1, 0., 1.2); // at five sixths of what is allowed: iterations alone would make it 1.5
  BOOST_TEST(std::abs(control.increment() - .8 * 1.2) < 1e-15);
  control.accept(1, 0., 100.);
  BOOST_TEST(std::abs(control.increment() - 1.5 * .8 * 1.2) < 1e-15);
  BOOST_TEST(control.reject(1.6));
  control.accept(1, 0., .85); // after a failure as well
  BOOST_TEST(std::abs(control.increment() - .8 * .85) < 1e-15);
  control.accept(1, 0., 1e-3);
  BOOST_TEST(control.increment() == 1e-2);
}

BOOST_AUTO_TEST_CASE(the_next_increment_is_shortened)
{
  const StepSettings what = settings();
  StepControl control(what, 0., 10., 1., 1e-2, 5., {});
  control.shorten(2.);
  BOOST_TEST(control.increment() == 1.);
  control.shorten(.3);
  BOOST_TEST(control.increment() == .3);
  control.shorten(1e-4);
  BOOST_TEST(control.increment() == 1e-2);
}

BOOST_AUTO_TEST_CASE(the_first_increment_lies_between_the_limits)
{
  const StepSettings what = settings();
  BOOST_TEST(StepControl(what, 0., 1., 1., .01, .1, {}).increment() == .1);
  BOOST_TEST(StepControl(what, 0., 1., 1e-6, .01, .1, {}).increment() == .01);
}

BOOST_AUTO_TEST_CASE(resumed_control_goes_on_as_the_first)
{
  const StepSettings what = settings();
  StepControl first(what, 0., 1., .01, 1e-6, .1, {});
  first.accept(2);
  first.reject(.01);
  StepControl second(what, 0., 1., .02, 1e-6, .1, {});
  second.restore(first.state());
  for (const unsigned int iterations : {3u, 20u, 8u, 1u}) // of which the first is waited for after the failure
  {
    BOOST_TEST(second.next(.3) == first.next(.3));
    first.accept(iterations);
    second.accept(iterations);
  }
  StepControl bounded(what, 0., 1., .1, .05, .1, {});
  bounded.restore(first.state());
  BOOST_TEST(bounded.increment() >= .05);
}

BOOST_AUTO_TEST_SUITE_END()
