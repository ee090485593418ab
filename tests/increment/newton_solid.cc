// Newton's method is quadratic on solids: elastic, plastic at large strain, in contact with friction.
#include "shell_problem.h"

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  const Entries two_across{"Blank/Elements through thickness=2"};

  double order_of(const NewtonResult &result)
  {
    const double order = observed_order(result.residuals, 1e-13);
    BOOST_TEST_MESSAGE("order " << order << ":" << listed_residuals(result.residuals));
    return order;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(newton_solid)

BOOST_AUTO_TEST_CASE(elastic)
{
  for_all_variants(two_across + Entries{"Material/Model=linear elastic"},
                   [](const Entries &entries) {
                     ShellProblem problem(entries, {}, {}, "solid");
                     check_order(problem.increment(1., 2.));
                     check_order(problem.increment(2., 4.));
                   });
}

BOOST_AUTO_TEST_CASE(plastic)
{
  for_all_variants(two_across + yielding,
                   [](const Entries &entries) {
                     ShellProblem problem(entries, {}, {}, "solid");
                     for (unsigned int k = 1; k < 10; ++k)
                       problem.increment(.1 * k, .2 * k);
                     BOOST_TEST(problem.blank->energy().plastic > 0.);
                     unsigned int good = 0;
                     for (unsigned int k = 10; k < 16; ++k)
                       good += order_of(problem.increment(.1 * k, 1.8 + .02 * (k - 9))) >= 1.8;
                     for (unsigned int k = 16; k < 20; ++k)
                       good += order_of(problem.increment(.1 * k, 1.9 - .2 * (k - 15))) >= 1.8; // unloading
                     // All but increments in whose last steps points begin or cease to yield
                     BOOST_TEST(good >= 8u);
                   });
}

BOOST_AUTO_TEST_CASE(in_contact_with_friction)
{
  for (const std::string enforcement : {"penalty", "active set"})
    for_all_variants(
      two_across + yielding,
      [&](const Entries &entries) {
        ShellProblem problem(entries, {"Enforcement=" + enforcement, "Allowed penetration=5e-2*.05"}, punch, "solid");
        unsigned int assessed = 0, good = 0;
        for (unsigned int k = 1; k <= 20; ++k)
        {
          const NewtonResult result = problem.increment(.01 * k, 0.);
          if (k < 6 || result.rounds > 0)
            continue; // first touches
          // A violation of the yield condition below some 1e-13 of the flow stress is none: no order below that.
          const double order = observed_order(result.residuals, 1e-12);
          if (std::isnan(order))
            continue;
          ++assessed;
          good += order >= 1.8;
          BOOST_TEST_MESSAGE(k << " order " << order << ":" << listed_residuals(result.residuals));
        }
        BOOST_TEST(problem.blank->energy().plastic > 0.);
        BOOST_TEST(problem.fixture->contact.n_touching() >= 3u);
        BOOST_TEST(assessed >= 5u);
        // All but increments whose last steps still change a status
        BOOST_TEST(good >= .8 * assessed, good << " of " << assessed);
      });
}

BOOST_AUTO_TEST_SUITE_END()
