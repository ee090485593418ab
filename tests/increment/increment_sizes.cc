// Sizes of increments: by iterations, and by an error of first order.
#include <deltaform/increment/step_control.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/section.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

namespace
{
  StepSettings settings(const std::vector<std::string> &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    return StepSettings(section);
  }
} // namespace


BOOST_AUTO_TEST_SUITE(increment_sizes)

BOOST_AUTO_TEST_CASE(iterations_alone)
{
  const StepSettings by_iterations = settings({"Target iterations=8"});
  StepControl control(by_iterations, 0., 1., .01, 1e-6, .05, {});
  control.accept(8, .3); // an error that nobody asked for
  BOOST_TEST(control.increment() == .01);
  control.accept(2);
  BOOST_TEST(control.increment() == .015, boost::test_tools::tolerance(1e-12));
  control.accept(32);
  BOOST_TEST(control.increment() == .0075, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(error_of_first_order_is_met)
{
  const StepSettings by_error = settings({"Flow error=1e-3", "Target iterations=1000"});
  StepControl control(by_error, 0., 1., .01, 1e-9, 1., {});
  // Ten times as much as asked at first; the process becomes four times as easy on the way.
  for (unsigned int i = 0; i < 40; ++i)
    control.accept(5, (i < 20 ? 1. : .25) * control.increment());
  BOOST_TEST(control.increment() == 4e-3, boost::test_tools::tolerance(.02));
}

BOOST_AUTO_TEST_CASE(the_shorter_of_the_two)
{
  const StepSettings both = settings({"Flow error=1e-3", "Target iterations=8"});
  StepControl control(both, 0., 1., .01, 1e-9, 1., {});
  control.accept(32, 1e-5);
  BOOST_TEST(control.increment() == .005, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(no_flow_no_limit)
{
  const StepSettings by_error = settings({"Flow error=1e-3", "Target iterations=1000"});
  StepControl control(by_error, 0., 1., .01, 1e-9, 1., {});
  control.accept(3, 0.);
  BOOST_TEST(control.increment() == .015, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(goes_on_from_a_state)
{
  const StepSettings by_error = settings({"Flow error=1e-3", "Target iterations=1000"});
  StepControl one(by_error, 0., 1., .01, 1e-9, 1., {});
  one.accept(3, 5e-3);
  StepControl other(by_error, 0., 1., .5, 1e-9, 1., {});
  other.restore(one.state());
  one.accept(3, 2e-3);
  other.accept(3, 2e-3);
  BOOST_TEST(one.increment() == other.increment());
}

BOOST_AUTO_TEST_SUITE_END()
