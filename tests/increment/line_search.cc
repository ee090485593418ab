// The search along a step, on functions of one variable.
#include <deltaform/increment/line_search.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <vector>

using namespace deltaform;

namespace
{
  /// Work along the unit step of the potential (a - root)^4 + (a - root)^2: negative before the root, positive behind.
  double work(const double a, const double root)
  {
    return 4. * std::pow(a - root, 3) + 2. * (a - root);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(line_search)

BOOST_AUTO_TEST_CASE(finds_where_the_work_is_small)
{
  for (const double root : {.05, .3, .7, .95})
  {
    LineSearch search;
    std::vector<double> visited;
    const double factor = search.search(1., work(0., root), work(1., root), .2, [&](const double a) {
      visited.push_back(a);
      return std::optional<double>(work(a, root));
    });
    BOOST_TEST(work(factor, root) <= .2 * std::abs(work(0., root)));
    BOOST_TEST(search.n_evaluations() == visited.size());
    // The state is left where the factor says.
    if (!visited.empty())
      BOOST_TEST(visited.back() == factor);
  }
}

BOOST_AUTO_TEST_CASE(a_step_that_is_good_enough_is_left_alone)
{
  LineSearch search;
  const double factor = search.search(.5, -1., .1, .2, [](double) { return std::optional<double>(0.); });
  BOOST_TEST(factor == .5);
  BOOST_TEST(search.n_evaluations() == 0u);
}

BOOST_AUTO_TEST_CASE(a_step_that_never_leads_down_is_cut_to_a_fiftieth)
{
  LineSearch search;
  const double factor = search.search(1., 1., 2., .2, [](double) { return std::optional<double>(2.); });
  BOOST_TEST(factor >= .02);
  BOOST_TEST(search.n_evaluations() <= 6u);
}

BOOST_AUTO_TEST_CASE(goes_back_from_where_the_laws_end)
{
  // Nothing can be evaluated below the whole step: it stays, and the state is brought back there.
  LineSearch search;
  std::vector<double> visited;
  const double factor = search.search(1., -1., 5., .2, [&](const double a) {
    visited.push_back(a);
    return a < 1. ? std::nullopt : std::optional<double>(5.);
  });
  BOOST_TEST(factor == 1.);
  BOOST_TEST(visited.back() == 1.);
  BOOST_TEST(visited.size() == search.n_evaluations() + 1u);
}

BOOST_AUTO_TEST_SUITE_END()
