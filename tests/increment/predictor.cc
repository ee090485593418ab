#include <deltaform/assembly/stiffness_view.h>
#include <deltaform/increment/predictor.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <sstream>
#include <tuple>
#include <utility>

using namespace deltaform;

namespace
{
  /// A stiff unknown and a soft one, without coupling.
  class TwoSprings : public StiffnessView
  {
  public:
    explicit TwoSprings(const double soft = 1e-3)
      : soft_(soft)
    {
    }

    void block(const DofIndex *, unsigned int, double *) const override
    {
    }

    void multiply(const Vector &direction, Vector &result) const override
    {
      result[0] = direction[0];
      result[1] = soft_ * direction[1];
    }

  private:
    double soft_;
  };


  using Path = std::function<std::pair<double, double>(double)>;

  Vector at(const Path &path, const double time)
  {
    Vector result(2);
    std::tie(result[0], result[1]) = path(time);
    return result;
  }


  /// After so many increments of lengths that change.
  Predictor after(const Path &path,
                  const unsigned int increments,
                  double &time,
                  const StiffnessView &tangent = TwoSprings())
  {
    Predictor result;
    time = 0.;
    for (unsigned int k = 0; k < increments; ++k)
    {
      const double length = k % 3 == 0 ? .1 : .05;
      result.accept(at(path, time), at(path, time + length), length, tangent);
      time += length;
    }
    return result;
  }


  double error(const Predictor &predictor, const Path &path, const double time, const double length)
  {
    Vector q = at(path, time);
    predictor.predict(length, q);
    return std::abs(q[0] - path(time + length).first);
  }


  double noise(const double time)
  {
    return 1e-3 * std::sin(1e4 * time * time);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(predictor)

BOOST_AUTO_TEST_CASE(nothing_is_known_at_first)
{
  const Predictor fresh;
  BOOST_TEST(fresh.last_length() == 0.);
  BOOST_TEST(fresh.fits(7));
  Vector q(2);
  q[0] = 3.;
  fresh.predict(.1, q);
  BOOST_TEST(q[0] == 3.);
}

BOOST_AUTO_TEST_CASE(a_straight_path_is_followed_exactly)
{
  const Path path = [](const double t) -> std::pair<double, double> { return {2. * t, -t}; };
  double time = 0.;
  for (const unsigned int n : {1u, 2u, 3u, 10u})
  {
    const Predictor predictor = after(path, n, time);
    BOOST_TEST(error(predictor, path, time, .03) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(half_of_a_trend_is_followed)
{
  const Path path = [](const double t) -> std::pair<double, double> { return {t * t, 0.}; };
  double time = 0.;
  const Predictor two = after(path, 2, time); // whether it is a trend is not known yet
  BOOST_TEST(two.weight() == 0.);
  BOOST_TEST(two.fits(2));
  BOOST_TEST(!two.fits(3));
  const Predictor ten = after(path, 10, time);
  BOOST_TEST(ten.weight() == .5, boost::test_tools::tolerance(1e-12));
  // The rate is that of the middle of the last increment, whose length is .1 in the tenth one.
  BOOST_TEST(ten.last_length() == .1);
  BOOST_TEST(error(ten, path, time, .04) == .5 * .04 * (.04 + .1), boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(noise_is_not_followed)
{
  const Path path = [](const double t) -> std::pair<double, double> { return {t * t * 1e-3 + noise(t), 0.}; };
  double time = 0.;
  BOOST_TEST(after(path, 60, time).weight() < .05);
}

BOOST_AUTO_TEST_CASE(what_is_stiff_decides)
{
  const Path path = [](const double t) -> std::pair<double, double> { return {t * t, 3. * noise(t)}; };
  double time = 0.;
  BOOST_TEST(after(path, 60, time).weight() > .4);
  BOOST_TEST(after(path, 60, time, TwoSprings(1e3)).weight() < .05);
}

BOOST_AUTO_TEST_CASE(a_tangent_that_is_not_definite_says_nothing)
{
  const Path path = [](const double t) -> std::pair<double, double> { return {0., t * t}; };
  double time = 0.;
  BOOST_TEST(after(path, 10, time, TwoSprings(-1.)).weight() == 0.);
  BOOST_TEST(after(path, 10, time, TwoSprings(0.)).weight() == 0.);
}

BOOST_AUTO_TEST_CASE(it_starts_anew)
{
  const Path path = [](const double t) -> std::pair<double, double> { return {t * t, t}; };
  double time = 0.;
  Predictor predictor = after(path, 10, time);
  predictor.restart();
  BOOST_TEST(predictor.last_length() == 0.);
  BOOST_TEST(predictor.weight() == 0.);
  Vector q = at(path, time);
  predictor.predict(.1, q);
  BOOST_TEST(q[1] == time);
}

BOOST_AUTO_TEST_CASE(on_a_finer_mesh_it_goes_on)
{
  const Path path = [](const double t) -> std::pair<double, double> { return {t * t, t}; };
  double time = 0.;
  Predictor predictor = after(path, 10, time);
  Vector coarse = at(path, time), fine(3);
  predictor.predict(.07, coarse);
  const double weight = predictor.weight();
  // A third unknown between the two.
  std::vector<Vector> steps = predictor.steps();
  BOOST_TEST_REQUIRE(steps.size() == 2u);
  for (Vector &step : steps)
  {
    const Vector two = step;
    step.reinit(3);
    step[0] = two[0];
    step[1] = .5 * (two[0] + two[1]);
    step[2] = two[1];
  }
  predictor.renumber(steps);
  BOOST_TEST(predictor.fits(3));
  BOOST_TEST(predictor.weight() == weight);
  BOOST_TEST(predictor.last_length() == 0.); // metal has no last increment there
  fine[0] = at(path, time)[0];
  fine[2] = at(path, time)[1];
  fine[1] = .5 * (fine[0] + fine[2]);
  predictor.predict(.07, fine);
  BOOST_TEST(std::abs(fine[0] - coarse[0]) < 1e-15);
  BOOST_TEST(std::abs(fine[2] - coarse[1]) < 1e-15);
  BOOST_TEST(std::abs(fine[1] - .5 * (coarse[0] + coarse[1])) < 1e-15);

  // Nothing is known at first, of any mesh.
  Predictor fresh;
  BOOST_TEST(fresh.steps().empty());
  fresh.renumber({});
  BOOST_TEST(fresh.fits(5));
  BOOST_TEST(fresh.last_length() == 0.);
}

BOOST_AUTO_TEST_CASE(saved_and_loaded_it_predicts_the_same)
{
  const Path path = [](const double t) -> std::pair<double, double> { return {t * t + noise(t), t}; };
  double time = 0.;
  const Predictor predictor = after(path, 20, time);
  std::stringstream stream;
  boost::archive::binary_oarchive(stream) << predictor;
  Predictor loaded;
  boost::archive::binary_iarchive(stream) >> loaded;
  Vector first = at(path, time), second = first;
  predictor.predict(.07, first);
  loaded.predict(.07, second);
  BOOST_TEST(first[0] == second[0]);
  BOOST_TEST(loaded.last_length() == predictor.last_length());
}

BOOST_AUTO_TEST_SUITE_END()
