#include <deltaform/assembly/stiffness_view.h>
#include <deltaform/increment/passage.h>

#include <deal.II/base/numbers.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

using namespace deltaform;

namespace
{
  constexpr std::size_t n_elements = 60, n_nodes = n_elements + 1, n_unknowns = 3 * n_nodes + 1; // and a tool
  constexpr double passing = .4; ///< time in which an element passes the tool
  constexpr double degree = dealii::numbers::PI / 180.;

  class Identity : public StiffnessView
  {
  public:
    explicit Identity(const double factor = 1.)
      : factor_(factor)
    {
    }

    void block(const DofIndex *, unsigned int, double *) const override
    {
    }

    void multiply(const Vector &direction, Vector &result) const override
    {
      result = direction;
      result *= factor_;
    }

  private:
    double factor_;
  };


  ElementChain chain()
  {
    ElementChain result;
    for (std::size_t i = 0; i < n_nodes; ++i)
      for (std::size_t c = 0; c < 3; ++c)
      {
        result.ahead.push_back(3 * std::min(i + 1, n_nodes - 1) + c);
        result.behind.push_back(3 * (i > 0 ? i - 1 : 0) + c);
        if (c == 2)
          result.rotations.push_back(3 * i + c);
      }
    return result;
  }


  /// Bend of an element over the time.
  using Bend = std::function<double(std::size_t, double)>;

  /// Elements of length 1 that bend; a tool moves with the time.
  Vector state(const Bend &bend, const double time)
  {
    Vector q(n_unknowns);
    for (std::size_t i = 0; i < n_elements; ++i)
    {
      q[3 * i + 5] = q[3 * i + 2] + bend(i, time);
      q[3 * i + 4] = q[3 * i + 1] + .5 * (q[3 * i + 2] + q[3 * i + 5]);
    }
    q[n_unknowns - 1] = time;
    return q;
  }


  /// Every element bends by @p angle while two pass, ever faster, until it lies on the tool. Those at the start come
  /// first, or those at the end.
  Bend drawn(const double angle, const bool towards_end)
  {
    return [=](const std::size_t i, const double time) {
      const double begin = passing * static_cast<double>(towards_end ? n_elements - 1 - i : i);
      const double s = std::clamp((time - begin) / (2. * passing), 0., 1.);
      return angle * s * s;
    };
  }


  /// A run with increments of one length.
  struct Run
  {
    Run(const Bend &bend_of_elements, const double each, const unsigned int n, const Identity &tangent = Identity())
      : bend(bend_of_elements), length(each)
    {
      for (unsigned int k = 0; k < n; ++k)
        go_on(tangent);
    }

    void go_on(const Identity &tangent = Identity())
    {
      passage.accept(state(bend, time), state(bend, time + length), rates(), length, tangent, chain());
      time += length;
    }

    /// The step that the rate of the last increment lets expect.
    Vector rates() const
    {
      Vector result = state(bend, time);
      result -= state(bend, std::max(time - length, 0.));
      return result;
    }

    /// Distance of @p step from what comes.
    double error(const Vector &step) const
    {
      Vector result = state(bend, time + length);
      result -= state(bend, time);
      result -= step;
      return result.l2_norm();
    }

    std::optional<Vector> step() const
    {
      return passage.step(rates(), length, chain());
    }

    Bend bend;
    double length, time = 0.;
    Passage passage;
  };
} // namespace

BOOST_AUTO_TEST_SUITE(passage)

BOOST_AUTO_TEST_CASE(elements_that_follow_each_other_are_foreseen)
{
  for (const bool towards_end : {false, true})
    for (const double parts : {5., 6.3, 3.1})
    {
      Run run(drawn(10. * degree, towards_end), passing / parts, static_cast<unsigned int>(8 * parts));
      BOOST_TEST(run.passage.lag() == passing, boost::test_tools::tolerance(.05));
      BOOST_TEST(run.passage.weight() > .8);
      double by_rates = 0., by_neighbours = 0.;
      for (unsigned int k = 0; k < 40; ++k, run.go_on())
      {
        BOOST_REQUIRE(run.step());
        by_rates += run.error(run.rates());
        by_neighbours += run.error(*run.step());
      }
      // The last element has no neighbour; increments that are no part of a passage are interpolated.
      BOOST_TEST(by_neighbours < (parts == 5. ? .15 : .4) * by_rates);
    }
}

BOOST_AUTO_TEST_CASE(a_tool_does_what_it_did)
{
  Run run(drawn(10. * degree, false), passing / 5., 20);
  BOOST_REQUIRE(run.step());
  BOOST_TEST((*run.step())[n_unknowns - 1] == run.length, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(what_is_no_passage_is_left_to_the_rates)
{
  // All elements bend at once, ever faster: where their neighbours were a while ago does not help.
  const Run together([](const std::size_t, const double time) { return time * time; }, .1, 40);
  BOOST_TEST(together.passage.weight() == 0.);
  BOOST_TEST(!together.step());
  BOOST_TEST(together.passage.longest() == std::numeric_limits<double>::infinity());
  // Nothing bends.
  const Run rigid([](const std::size_t, const double) { return 0.; }, .1, 40);
  BOOST_TEST(!rigid.step());
  // Each element has a rhythm of its own.
  const auto own_rhythm = [](const std::size_t i, const double time) {
    return std::sin(time * (1. + .37 * static_cast<double>(i * i % 11)));
  };
  const Run alone(own_rhythm, .1, 60);
  BOOST_TEST(!alone.step());
}

BOOST_AUTO_TEST_CASE(an_element_that_takes_too_many_increments_is_not_known)
{
  const Run run(drawn(10. * degree, false), passing / 60., 600);
  BOOST_TEST(!run.step());
}

BOOST_AUTO_TEST_CASE(it_is_not_used_for_increments_longer_than_a_passage)
{
  const Run run(drawn(10. * degree, false), passing / 5., 20);
  BOOST_TEST(run.passage.step(run.rates(), .9 * passing, chain()).has_value());
  BOOST_TEST(!run.passage.step(run.rates(), 1.1 * passing, chain()).has_value());
}

BOOST_AUTO_TEST_CASE(increments_are_parts_of_a_passage_where_elements_bend_much)
{
  for (const auto &[angle, parts] : {std::make_pair(10., 4.), {7., 3.}, {4., 2.}, {2., 1.}})
  {
    const Run run(drawn(angle * degree, false), passing / 8., 80); // three quarters of it while one passes
    BOOST_TEST(run.passage.longest() == passing / parts, boost::test_tools::tolerance(1e-3));
  }
  // Where they are longer already they may stay.
  const Run run(drawn(10. * degree, false), passing / 2., 40);
  BOOST_REQUIRE(run.passage.weight() > 0.);
  BOOST_TEST(run.passage.longest() == passing / 2., boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(after_a_failure_it_has_to_be_found_anew)
{
  Run run(drawn(10. * degree, false), passing / 5., 20);
  BOOST_REQUIRE(run.step());
  run.passage.distrust();
  BOOST_TEST(!run.step());
  run.go_on();
  BOOST_TEST(run.step().has_value());
}

BOOST_AUTO_TEST_CASE(a_tangent_that_is_not_definite_says_nothing)
{
  BOOST_TEST(!Run(drawn(10. * degree, false), passing / 5., 20, Identity(-1.)).step());
  BOOST_TEST(!Run(drawn(10. * degree, false), passing / 5., 20, Identity(0.)).step());
}

BOOST_AUTO_TEST_CASE(a_blank_without_a_chain_keeps_nothing)
{
  Passage fresh;
  fresh.accept(Vector(4), Vector(4), Vector(4), .1, Identity(), ElementChain());
  BOOST_TEST(fresh.fits(7));
  BOOST_TEST(!fresh.step(Vector(4), .1, ElementChain()).has_value());
  BOOST_TEST(fresh.longest() == std::numeric_limits<double>::infinity());
}

BOOST_AUTO_TEST_CASE(saved_and_loaded_it_goes_on_the_same)
{
  Run run(drawn(10. * degree, false), passing / 5.3, 40), loaded = run;
  loaded.passage = Passage();
  std::stringstream stream;
  boost::archive::binary_oarchive(stream) << run.passage;
  boost::archive::binary_iarchive(stream) >> loaded.passage;
  BOOST_TEST(loaded.passage.fits(n_unknowns));
  BOOST_TEST(!loaded.passage.fits(n_unknowns + 1));
  for (unsigned int k = 0; k < 3; ++k, run.go_on(), loaded.go_on())
  {
    BOOST_REQUIRE(run.step());
    Vector difference = *run.step();
    difference -= *loaded.step();
    BOOST_TEST(difference.linfty_norm() == 0.);
    BOOST_TEST(loaded.passage.longest() == run.passage.longest());
  }
}

BOOST_AUTO_TEST_SUITE_END()
