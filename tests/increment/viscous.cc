// The way to another equilibrium as in a viscous medium: on an arch, on a body that nothing holds, and with a set that
// has to be that of the last good step.
#include "arch.h"

#include <deltaform/increment/strategy.h>
#include <deltaform/increment/viscous_equations.h>
#include <deltaform/increment/viscous_motion.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  using Outcome = NewtonResult::Outcome;

  constexpr double beyond_the_limit = .4049; // the limit point is at .3849

  NewtonResult solve(ArchFixture &fixture, Vector &q, const double time, const std::string &name = "viscous")
  {
    const auto strategy = StrategyMakers::make(name);
    q = *strategy->begin(fixture.problem, {time, time, true, fixture.predictor});
    return strategy->solve(fixture.problem, fixture.newton, q);
  }


  /// An arch whose set is wrong after a step that failed: with a wrong one the laws cannot be evaluated.
  class ArchWithSet : public Arch, public ActiveSet
  {
  public:
    ActiveSet *active_set() override
    {
      return this;
    }
    std::size_t signature() const override
    {
      return 0;
    }
    void prepare_step(const Vector &) override
    {
    }
    void advance(double) override
    {
      set += .5;
    }
    bool changed() const override
    {
      return false;
    }
    unsigned int patience() const override
    {
      return 0;
    }
    bool consistent(double) const override
    {
      return true;
    }
    void keep() override
    {
      kept = set;
      ++n_kept;
    }
    void go_back() override
    {
      set = kept;
      ++n_returns;
    }

    double set = 0., kept = -1.;
    unsigned int n_kept = 0, n_returns = 0;
  };
} // namespace

BOOST_AUTO_TEST_SUITE(viscous)

BOOST_AUTO_TEST_CASE(forces_of_the_medium)
{
  Arch arch;
  arch.time = .1;
  const std::vector<double> scale{3., 1.};
  arch.system.set_prescribed({false, true});
  Vector q(2), start(2);
  q[0] = .2;
  start[0] = .15;
  BOOST_TEST(arch.assemble(q, true).good());
  const double force = arch.system.residual()[0], slope = arch.system.diagonal(0), held = arch.system.diagonal(1);
  ViscousEquations viscous(arch, arch.system, scale);
  viscous.begin_step(start, 2.);
  BOOST_TEST(viscous.assemble(q, true).good());
  // c scale^2 (q - q_k) = 2 * 9 * .05, and nothing on what is prescribed.
  BOOST_TEST(arch.system.residual()[0] == force + .9, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(arch.system.diagonal(0) == slope + 18., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(arch.system.diagonal(1) == held);
  BOOST_TEST(!viscous.assemble_foreseen(q)); // as the arch
  arch.touches = arch.is_stiff = true;
  BOOST_TEST(!viscous.assemble(q, true).good());
}

BOOST_AUTO_TEST_CASE(an_arch_snaps_through)
{
  // From every start below the limit point, and never back from it: the motion goes down the potential.
  for (const double start : {0., .2, .4})
  {
    ArchFixture fixture;
    fixture.problem.q[0] = start;
    Vector q;
    BOOST_TEST(solve(fixture, q, beyond_the_limit).converged());
    const double u = q[0];
    BOOST_TEST(u > 2.);
    BOOST_TEST(std::abs(u * (u - 1.) * (u - 2.) - beyond_the_limit) < 1e-6);
    BOOST_TEST(fixture.problem.q[0] == start);
  }
}

BOOST_AUTO_TEST_CASE(the_nearest_equilibrium_down_the_potential)
{
  // Below the limit there are three; from beside the unstable one, .899, it goes to that on its side.
  for (const double start : {.5, .8, .895, .905, 1.05, 1.8})
  {
    ArchFixture fixture;
    fixture.problem.q[0] = start;
    Vector q;
    BOOST_TEST(solve(fixture, q, .1).converged());
    BOOST_TEST((start < .9 ? q[0] < .1 : q[0] > 2.), q[0]);
  }
}

BOOST_AUTO_TEST_CASE(at_rest_forces_have_a_few_steps_to_balance)
{
  ArchFixture fixture;
  Vector q;
  const auto balanced = solve(fixture, q, beyond_the_limit);
  fixture.problem.forces_left = 6e-4;
  const auto left = solve(fixture, q, beyond_the_limit);
  BOOST_TEST((balanced.converged() && left.converged()));
  BOOST_TEST(left.iterations > balanced.iterations);
  BOOST_TEST(left.iterations < balanced.iterations + 25u);
  BOOST_TEST(q[0] > 2.);
}

BOOST_AUTO_TEST_CASE(close_to_rest_it_goes_on)
{
  const auto from = [](const double start, const unsigned int most_iterations) {
    ArchFixture fixture;
    fixture.problem.q[0] = start;
    fixture.problem.begin(.1, 0.);
    Vector q = fixture.problem.committed();
    return ViscousMotion(fixture.problem, fixture.newton, q, most_iterations).run();
  };
  // A start where the forces of the medium are small at once; it takes more than the three iterations of a first step.
  const NewtonResult close = from(1.8, 1000);
  BOOST_REQUIRE(close.converged());
  BOOST_REQUIRE(close.iterations > 5);
  BOOST_TEST(from(1.8, 3).converged());
  // Far from rest it ends.
  BOOST_TEST(from(1.5, 1000).converged());
  BOOST_TEST((from(1.5, 30).outcome == Outcome::diverged));
}

BOOST_AUTO_TEST_CASE(what_nothing_holds_is_said)
{
  // A load without anything against it: in the medium it goes on and on.
  ArchFixture fixture;
  fixture.problem.is_free = true;
  Vector q;
  const auto result = solve(fixture, q, .1);
  BOOST_TEST((result.outcome == Outcome::singular));
  BOOST_TEST(result.iterations < 250u);
  BOOST_TEST(std::abs(q[0]) > 1.);
  const auto attempt = fixture.to(.1, Effort::all);
  BOOST_REQUIRE(attempt.rejected.has_value());
  BOOST_TEST(attempt.rejected->sentence.find("free to move") != std::string::npos, attempt.rejected->sentence);
}

BOOST_AUTO_TEST_CASE(it_ends)
{
  // No step leads anywhere: the viscosity grows until it is hopeless.
  ArchFixture fixture;
  fixture.problem.share_of_steps = 1e-7;
  Vector q;
  const auto stuck = solve(fixture, q, beyond_the_limit);
  BOOST_TEST((stuck.outcome == Outcome::diverged));
  BOOST_TEST(stuck.iterations < 250u);
  BOOST_TEST(std::abs(q[0]) < 1e-9);
  // Steps of the hundredth part lead somewhere, slowly: to the end of the iterations, and further with more of them.
  fixture.problem.share_of_steps = .02;
  const auto slow = solve(fixture, q, beyond_the_limit);
  BOOST_TEST(!slow.converged());
  BOOST_TEST(slow.iterations < 250u + 20u);
}

BOOST_AUTO_TEST_CASE(a_step_that_fails_leaves_no_set_behind)
{
  ArchWithSet arch;
  arch.q[0] = .4;
  Timers timers;
  const std::vector<double> scale(2, 1.), size(2, 10.);
  const NewtonSettings settings = newton_settings({"Maximal iterations=4"});
  Newton newton(arch, arch.system, settings, scale, size, timers);
  const auto strategy = StrategyMakers::make("viscous, a long way");
  const Predictor predictor;
  Vector q = *strategy->begin(arch, {beyond_the_limit, beyond_the_limit, true, predictor});
  BOOST_TEST(strategy->solve(arch, newton, q).converged());
  BOOST_TEST(arch.n_returns > 0u); // equilibrium was tried too early
  BOOST_TEST(arch.n_kept > 4u);
  BOOST_TEST(arch.set > arch.kept);
}

BOOST_AUTO_TEST_SUITE_END()
