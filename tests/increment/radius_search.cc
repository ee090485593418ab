// The step of Newton's method within a radius.
#include <deltaform/increment/radius_search.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <vector>

using namespace deltaform;

namespace
{
  /// Springs side by side, each with its own force.
  struct Springs
  {
    std::vector<double> stiffness, force;
    std::vector<double> step = {};
    unsigned int n_solves = 0;

    double length(const double mu)
    {
      ++n_solves;
      double square = 0.;
      step.clear();
      for (std::size_t i = 0; i < stiffness.size(); ++i)
      {
        step.push_back(force[i] / (stiffness[i] + mu));
        square += step[i] * step[i];
      }
      return std::sqrt(square);
    }
    double total_force() const
    {
      double square = 0.;
      for (const double f : force)
        square += f * f;
      return std::sqrt(square);
    }
    /// @return length of the step that was found
    double find(RadiusSearch &search, const double radius)
    {
      n_solves = 0;
      BOOST_TEST(search.find(radius, total_force(), [this](const double mu) { return length(mu); }));
      return std::hypot(step[0], step.size() > 1 ? step[1] : 0.);
    }
  };
} // namespace

BOOST_AUTO_TEST_SUITE(radius_search)

BOOST_AUTO_TEST_CASE(without_a_radius_it_is_the_whole_step)
{
  Springs springs{{1e3, 1e-6}, {1., .1}};
  RadiusSearch search;
  BOOST_TEST(springs.find(search, INFINITY) > 9e4);
  BOOST_TEST(search.stiffness() == 0.);
  BOOST_TEST(springs.n_solves == 1u);
}

BOOST_AUTO_TEST_CASE(a_short_step_is_not_damped)
{
  Springs springs{{1e3, 1.}, {1., .1}};
  RadiusSearch search;
  springs.find(search, 10.);
  BOOST_TEST(search.stiffness() == 0.);
  BOOST_TEST(springs.step[1] == .1);
}

BOOST_AUTO_TEST_CASE(what_nothing_resists_comes_to_the_radius_and_what_is_stiff_keeps_its_step)
{
  Springs springs{{1e3, 1e-6}, {1., 1e-3}};
  for (const double radius : {.02, .2, 2., 50.})
  {
    RadiusSearch search;
    const double length = springs.find(search, radius);
    BOOST_TEST_CONTEXT("radius " << radius)
    {
      BOOST_TEST(length >= .5 * radius);
      BOOST_TEST(length <= 1.2 * radius);
      BOOST_TEST(springs.step[0] == 1e-3, boost::test_tools::tolerance(1e-3));
      BOOST_TEST(springs.n_solves <= 5u);
      // The next radius begins with what is known: four times as long, or as little as was taken of a step.
      springs.find(search, 4. * radius);
      BOOST_TEST(springs.n_solves <= 2u);
      springs.find(search, .3 * radius);
      BOOST_TEST(springs.n_solves <= 2u);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_indefinite_tangent_ends_it_all_the_same)
{
  Springs springs{{1e3, -1.}, {1., 1e-3}};
  RadiusSearch search;
  springs.find(search, 1e4); // |R|/radius is far from enough to turn the sign
  BOOST_TEST(springs.n_solves <= 7u);
  springs.find(search, 1e-2);
  BOOST_TEST(springs.n_solves <= 7u);
  BOOST_TEST(search.stiffness() > 1.);
}

BOOST_AUTO_TEST_CASE(where_there_is_no_step_it_says_so)
{
  RadiusSearch search;
  BOOST_TEST(!search.find(1., 1., [](double) { return std::nullopt; }));
}

BOOST_AUTO_TEST_SUITE_END()
