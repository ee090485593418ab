// The surface of a half-space against closed forms (H.S. Carslaw, J.C. Jaeger, Conduction of Heat in Solids, 1959).
#include <deltaform/heat/half_space.h>
#include <deltaform/parameters/scene_error.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

using namespace deltaform;

namespace
{
  /// Rise of the surface under a unit flux since @p time.
  double unit_rise(const double effusivity, const double time)
  {
    return time > 0. ? 2. / effusivity * std::sqrt(time / std::acos(-1.)) : 0.;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(half_space)

// Fluxes that are constant over increments of any length: the sum of their closed forms (section 2.9).
BOOST_AUTO_TEST_CASE(constant_fluxes)
{
  const double effusivity = 12.;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> exponent(-7., 1.), size(-3., 5.);
  for (int run = 0; run < 50; ++run)
  {
    HalfSpace tool(effusivity, 2);
    std::vector<double> ends{0.}, fluxes;
    for (int i = 0; i < 20; ++i)
    {
      const double duration = std::pow(10., exponent(generator)), flux = size(generator);
      tool.begin(duration);
      tool.end({flux, 0.});
      ends.push_back(ends.back() + duration);
      fluxes.push_back(flux);
      double expected = 0., largest = 0.;
      for (int k = 0; k <= i; ++k)
      {
        const double now = ends.back();
        expected += fluxes[k] * (unit_rise(effusivity, now - ends[k]) - unit_rise(effusivity, now - ends[k + 1]));
        largest += std::abs(fluxes[k]) * unit_rise(effusivity, now - ends[k]);
      }
      BOOST_TEST_REQUIRE(std::abs(tool.rise()[0] - expected) <= 3e-6 * largest,
                         tool.rise()[0] << " instead of " << expected);
      BOOST_TEST(tool.rise()[1] == 0.);
    }
  }
}

// From a billionth of the unit of time to a billion of it.
BOOST_AUTO_TEST_CASE(times)
{
  for (const double time : {1e-9, 1e-6, 1e-3, 1., 1e3, 1e6, 1e9})
    for (const int n : {1, 100})
    {
      HalfSpace tool(3., 1);
      for (int i = 0; i < n; ++i)
      {
        tool.begin(time / n);
        tool.end({5.});
      }
      const double error = tool.rise()[0] / (5. * unit_rise(3., time)) - 1.;
      BOOST_TEST(std::abs(error) < 4e-6, "after " << time << ": " << error);
    }
}

// A body of constant temperature behind a joint: the surface rises by 1 - exp(x^2) erfc(x), x = h sqrt(t)/e (section
// 2.7). Also where the joint is so good that one increment equals both temperatures.
BOOST_AUTO_TEST_CASE(joint)
{
  const double effusivity = 2., body = 100.;
  for (const double conductance : {.1, 3., 1e12})
  {
    double last = 0.;
    for (const int n : {200, 400})
    {
      HalfSpace tool(effusivity, 1);
      for (int i = 0; i < n; ++i)
      {
        tool.begin(1. / n);
        const double elsewhere = .25; // of a joint without flux from elsewhere
        const auto [h, outside] = tool.joint(0, conductance, 0.);
        const auto [same, warmer] = tool.joint(0, conductance, elsewhere);
        BOOST_TEST(same == h);
        BOOST_TEST(warmer > outside);
        tool.end({h * (body - outside)});
        // The flux is that through the joint at the end.
        const double flux = conductance * (body - tool.rise()[0]);
        if (conductance < 1e6)
          BOOST_TEST(std::abs(h * (body - outside) - flux) <= 1e-10 * flux);
      }
      const double x = conductance / effusivity;
      const double expected = x < 20. ? body * (1. - std::exp(x * x) * std::erfc(x)) : body;
      const double error = std::abs(tool.rise()[0] / expected - 1.);
      BOOST_TEST(error < 2e-3, error);
      if (conductance < 1e6 && last > 0.)
        BOOST_TEST(std::abs(last / error - 2.) < .3, last << " " << error);
      last = error;
    }
  }
}

BOOST_AUTO_TEST_CASE(refined_and_saved)
{
  HalfSpace tool(1., 2), fine(1., 3);
  const auto both = [&](const double duration, const double a, const double b) {
    tool.begin(duration);
    tool.end({a, b});
    fine.begin(duration);
    fine.end({a, .5 * (a + b), b});
  };
  both(.1, 3., 1.);
  both(1e-3, 3., 0.);
  tool.transfer({{0, 0, 0.}, {0, 1, .5}, {1, 1, 0.}});
  HalfSpace other(1., 0);
  BOOST_CHECK_THROW(other.set_state(tool.state(), 4), SceneError);
  other.set_state(tool.state(), 3);
  for (HalfSpace *const one : {&tool, &fine, &other})
  {
    one->begin(2.);
    one->end({0., 0., -1.});
  }
  BOOST_TEST(tool.rise() == fine.rise(), boost::test_tools::tolerance(1e-13) << boost::test_tools::per_element());
  BOOST_TEST(other.rise() == tool.rise());
  BOOST_TEST(other.state() == tool.state());
}

BOOST_AUTO_TEST_SUITE_END()
