// Newton's method on problems of one or two unknowns: every way in which it may end.
#include "../solver/mpi.h"
#include "convergence.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <functional>
#include <utility>

using namespace deltaform;
using namespace deltaform::testing;
using Outcome = NewtonResult::Outcome;

namespace
{
  /// R(u) = internal(u) - load of one unknown, which is tied by a spring of stiffness 1 to a second one that is
  /// prescribed.
  class Scalar : public Equations, public ActiveSet
  {
  public:
    using Function = std::function<double(double)>;

    Scalar(Function internal_force, Function derivative, const double external_force)
      : internal(std::move(internal_force)), slope(std::move(derivative)), load(external_force),
        system(full_pattern(2), 0, "klu")
    {
    }

    double typical_length() const override
    {
      return 1.;
    }

    Status assemble(const Vector &state, const bool tangent) override
    {
      system.clear(tangent);
      visited.push_back(state[0]);
      if (!allowed(state[0]))
        return Status::shorten("not allowed");
      const DofIndex dofs[] = {0, 1};
      const double force = internal(state[0]), stiffness = slope(state[0]), external = -load;
      system.add(dofs, 1, tangent ? &stiffness : nullptr, &force);
      system.add(dofs, 1, nullptr, &external);
      const double stretch = spring * (state[1] - state[0]), forces[] = {-stretch, stretch};
      const double block[] = {spring, -spring, -spring, spring};
      system.add(dofs, 2, tangent ? block : nullptr, forces);
      return {};
    }

    double limit_step(const Vector &, Vector &d) const override
    {
      return std::min(1., largest_step / std::max(std::abs(d[0]), 1e-300));
    }

    ActiveSet *active_set() override
    {
      return this;
    }

    std::size_t signature() const override
    {
      return 0;
    }

    void prepare_step(const Vector &d) override
    {
      step = d[0];
    }

    void advance(const double factor) override
    {
      factors.push_back(factor);
    }

    bool changed() const override
    {
      return false;
    }

    unsigned int patience() const override
    {
      return 0;
    }

    bool consistent(const double) const override
    {
      return n_inconsistent == 0 || n_inconsistent-- == 0;
    }

    unsigned int correct_early() override
    {
      ++n_asked_early;
      return correct(n_early_corrections);
    }

    unsigned int correct(const Vector & /*q*/) override
    {
      return correct(n_corrections);
    }

    double imbalance() const override
    {
      return forces_left(visited.back());
    }

    NewtonResult solve(const double start,
                       const std::vector<std::string> &entries = {},
                       const double goal = 0.)
    {
      const NewtonSettings settings = newton_settings(entries);
      Timers timers;
      const std::vector<double> scale(2, 1.), size(2, 1.);
      Newton newton(*this, system, settings, scale, size, timers);
      q.reinit(2);
      q[0] = start;
      Vector prescribed = q;
      auto committed = q;
      committed[0] -= way;
      prescribed[1] = goal;
      visited.clear();
      factors.clear();
      return newton.solve(q, prescribed, {false, true}, committed, 0.);
    }

    /// The load grows as often as @p n_left says.
    unsigned int correct(unsigned int &n_left)
    {
      if (n_left == 0)
        return 0;
      --n_left;
      load *= 1.1;
      return 1;
    }

    Function internal, slope;
    double load, spring = 0., largest_step = 1e300, step = 0.;
    double way = 0.; ///< that the increment has moved the start
    std::function<bool(double)> allowed = [](double) { return true; };
    std::function<double(double)> forces_left = [](double) { return 0.; };
    unsigned int n_corrections = 0, n_early_corrections = 0, n_asked_early = 0;
    mutable unsigned int n_inconsistent = 0;
    System system;
    Vector q;
    std::vector<double> visited, factors;
  };

  /// Soft to .5, stiff beyond; from .1 on only when an inequality has let go, which the search for sets finds.
  class Releasing : public Scalar
  {
  public:
    Releasing()
      : Scalar([](const double u) { return 1e3 + 1e-3 * u + 1e3 * std::max(u - .5, 0.); },
               [this](const double u) { return u > .5 ? 1e3 : (u > .1 && !is_released ? 10. : 1e-3); },
               1000.2)
    {
    }

    bool foresee(const Vector &state, const Vector & /*d*/) override
    {
      return state[0] > .1 && state[0] < .5 && !std::exchange(is_released, true);
    }

    bool assemble_foreseen(const Vector &state) override
    {
      return assemble(state, true).good();
    }

    bool is_released = false;
  };

  Scalar stiffening(const double load)
  {
    return {[](const double u) { return u + u * u * u; }, [](const double u) { return 1. + 3. * u * u; }, load};
  }

  Scalar saturating(const double load)
  {
    return {[](const double u) { return std::atan(u); }, [](const double u) { return 1. / (1. + u * u); }, load};
  }
} // namespace

BOOST_AUTO_TEST_SUITE(newton)

BOOST_AUTO_TEST_CASE(quadratic_convergence)
{
  Scalar problem = stiffening(10.);
  const NewtonResult result = problem.solve(0., {"Force tolerance=1e-12"});
  BOOST_TEST(result.converged());
  BOOST_TEST(std::abs(problem.q[0] - 2.) < 1e-12);
  BOOST_TEST(result.residuals.size() == result.iterations + 1u);
  BOOST_TEST(observed_order(result.residuals, 1e-12) > 1.8, listed_residuals(result.residuals));
  // A wrong tangent does not pass for a quadratic one.
  problem.slope = [](const double u) { return 1.05 * (1. + 3. * u * u); };
  BOOST_TEST(observed_order(problem.solve(0., {"Force tolerance=1e-12"}).residuals, 1e-12) < 1.2);
}

BOOST_AUTO_TEST_CASE(a_linear_problem_takes_one_iteration)
{
  Scalar problem([](const double u) { return 3. * u; }, [](double) { return 3.; }, 6.);
  const NewtonResult result = problem.solve(0.);
  BOOST_TEST(result.converged());
  BOOST_TEST(result.iterations == 1u);
  BOOST_TEST(problem.q[0] == 2.);
}

BOOST_AUTO_TEST_CASE(loads_that_start_at_zero_do_not_stall)
{
  Scalar problem = stiffening(0.);
  const NewtonResult result = problem.solve(0.);
  BOOST_TEST(result.converged());
  BOOST_TEST(result.iterations <= 1u);
}

BOOST_AUTO_TEST_CASE(prescribed_unknowns_move_their_neighbours)
{
  Scalar problem = stiffening(0.);
  problem.spring = 2.;
  const NewtonResult result = problem.solve(0., {"Force tolerance=1e-12"}, 3.);
  BOOST_TEST(result.converged());
  BOOST_TEST(problem.q[1] == 3.);
  const double u = problem.q[0];
  BOOST_TEST(std::abs(u + u * u * u - 2. * (3. - u)) < 1e-11);
  BOOST_TEST(problem.visited[1] > 0.); // in the first iteration
  // In parts where the step is not admissible as a whole
  problem.largest_step = .25;
  const NewtonResult slower = problem.solve(0., {"Force tolerance=1e-12"}, 3.);
  BOOST_TEST(slower.converged());
  BOOST_TEST(problem.q[1] == 3.);
  BOOST_TEST(std::abs(problem.q[0] - u) < 1e-11);
  BOOST_TEST(std::abs(problem.visited[1]) <= .25 * (1. + 1e-12));
  BOOST_TEST(slower.iterations > result.iterations);
}

BOOST_AUTO_TEST_CASE(the_line_search_finds_what_full_steps_miss)
{
  Scalar problem = saturating(1.);
  BOOST_TEST(!problem.solve(8., {"Line search=false"}).converged());
  const NewtonResult result = problem.solve(8., {"Force tolerance=1e-10"});
  BOOST_TEST(result.converged());
  BOOST_TEST(result.line_searches > 0u);
  BOOST_TEST(std::abs(problem.q[0] - std::tan(1.)) < 1e-8);
  // The problem is told how far every step went before it is assembled there.
  BOOST_TEST(problem.factors.size() + 1u == problem.visited.size());
  BOOST_TEST(problem.factors[0] == 1.);
  BOOST_TEST(problem.factors[1] < 1.);
}

BOOST_AUTO_TEST_CASE(steps_that_nothing_resists_are_damped)
{
  // Of two large forces in balance, one takes part of a step only: full steps go to and fro farther and farther away.
  Scalar problem = saturating(0.);
  problem.internal = [](const double u) { return 1e3 + std::atan(u); };
  problem.load = 1e3;
  const NewtonResult result = problem.solve(100.);
  BOOST_TEST(result.converged(), listed_residuals(result.residuals));
  BOOST_TEST(std::abs(problem.q[0]) < 2.1e-3); // the tolerance, 1e-6 of 2e3
  // Undamped steps only grow: the first one already.
  BOOST_TEST(problem.factors.size() > 2u);
  BOOST_TEST(problem.visited[1] < -1e4);
}

BOOST_AUTO_TEST_CASE(a_long_step_that_leads_nowhere_is_replaced)
{
  // Two large forces, 1e-4 off balance: soft to .5, where what was elastic is stiff.
  Scalar problem([](const double u) { return 1e3 + 1e-3 * u + 1e3 * std::max(u - .5, 0.); },
                 [](const double u) { return u > .5 ? 1e3 : 1e-3; },
                 1000.2);
  const auto places = [&](const double way) {
    problem.way = way;
    const NewtonResult result = problem.solve(0.);
    BOOST_TEST(result.converged(), listed_residuals(result.residuals));
    BOOST_TEST(problem.q[0] == .5002, boost::test_tools::tolerance(1e-2));
    return problem.visited;
  };
  const auto tolerance = boost::test_tools::tolerance(1e-2);
  const double whole = 200.;
  // The whole step, back to the start, and about a twentieth of what was foreseen of the increment.
  const auto visited = places(4.);
  BOOST_TEST(visited[1] == whole, tolerance);
  BOOST_TEST(visited[2] == 0.);
  const double replaced = *std::find_if(visited.begin() + 2, visited.end(), [](const double u) { return u != 0.; });
  BOOST_TEST(replaced >= .5 * .2);
  BOOST_TEST(replaced <= 1.2 * .2);
  // It is not long, or nothing was foreseen: the line search goes on from its end.
  for (const double way : {5000., 0.})
  {
    const auto others = places(way);
    BOOST_TEST(others[1] == whole, tolerance);
    BOOST_TEST(others[2] > 0.);
  }
}

BOOST_AUTO_TEST_CASE(another_set_does_not_make_a_step_longer_than_its_radius)
{
  Releasing problem;
  problem.way = 4.; // so that the first radius is a twentieth of that
  const NewtonResult result = problem.solve(0.);
  BOOST_TEST(result.converged(), listed_residuals(result.residuals));
  BOOST_TEST(problem.is_released);
  BOOST_TEST(problem.q[0] == .5002, boost::test_tools::tolerance(1e-2));
  // The whole step is 200; the second radius is four times the first, and where it leads to the force turns round.
  const auto second =
    std::find_if(problem.visited.begin() + 2, problem.visited.end(), [](double u) { return u != 0.; });
  BOOST_TEST(*std::max_element(second, problem.visited.end()) <= .5 + 1.2 * .8);
}

BOOST_AUTO_TEST_CASE(a_balanced_state_that_the_solve_comes_back_to_is_its_end)
{
  // Balanced at 0 to 1e-7 of the forces, where the slope asks for a step of 200; what is there leads back.
  const auto force = [](const double u) { return u > -1. ? 2e-4 + 1e-6 * u : u; };
  Scalar problem([&](const double u) { return 1e3 + force(u); },
                 [](const double u) { return u > -1. ? 1e-6 : 1.; },
                 1e3);
  problem.spring = 0.;
  const NewtonResult result = problem.solve(-200., {"Line search=false"});
  BOOST_TEST(result.converged(), listed_residuals(result.residuals));
  BOOST_TEST(std::abs(problem.q[0]) < 1e-3);
  BOOST_TEST(result.iterations == 3u); // to 0, away, and to 0 again
}

BOOST_AUTO_TEST_CASE(forbidden_states_are_avoided)
{
  Scalar problem = stiffening(10.);
  problem.allowed = [](const double u) { return u < 2.5; };
  const NewtonResult result = problem.solve(0., {"Force tolerance=1e-10"}); // the first step goes to 10
  BOOST_TEST(result.converged());
  BOOST_TEST(std::abs(problem.q[0] - 2.) < 1e-8);

  problem.allowed = [](const double u) { return u < 1e-6; };
  const NewtonResult failed = problem.solve(0.);
  BOOST_TEST((failed.outcome == Outcome::inadmissible));
  BOOST_TEST(std::string(failed.status.cause) == "not allowed");

  problem.allowed = [](double) { return false; };
  BOOST_TEST((problem.solve(0.).outcome == Outcome::inadmissible));
}

BOOST_AUTO_TEST_CASE(failures_are_told_apart)
{
  // No solution
  Scalar nowhere([](const double u) { return 1. + u * u; }, [](const double u) { return 2. * u; }, 0.);
  const NewtonResult lost = nowhere.solve(1., {"Maximal iterations=15"});
  BOOST_TEST((lost.outcome == Outcome::diverged || lost.outcome == Outcome::singular));
  BOOST_TEST(lost.iterations <= 15u);
  // Nothing holds the unknown
  Scalar free([](double) { return 0.; }, [](double) { return 0.; }, 1.);
  BOOST_TEST((free.solve(0.).outcome == Outcome::singular));
  // Numbers that are none
  Scalar wrong([](double) { return std::numeric_limits<double>::quiet_NaN(); }, [](double) { return 1.; }, 1.);
  BOOST_TEST(!wrong.solve(0.).converged());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_assembled_again_is_said)
{
  // The correction makes the state that was found impossible.
  Scalar corrected = stiffening(10.);
  corrected.n_corrections = 1;
  corrected.allowed = [&](double) { return corrected.n_corrections > 0; };
  const NewtonResult first = corrected.solve(0.);
  BOOST_TEST((first.outcome == Outcome::inadmissible));
  BOOST_TEST(first.rounds == 1u);
  BOOST_TEST(std::string(first.status.cause) == "not allowed");
  // So is the second assembly, which a singular matrix asks for.
  Scalar problem([](double) { return 0.; }, [](double) { return 0.; }, 1.);
  unsigned int n = 0;
  problem.allowed = [&](double) { return ++n == 1; };
  const NewtonResult second = problem.solve(0.);
  BOOST_TEST((second.outcome == Outcome::inadmissible));
  BOOST_TEST(n == 2u);
}

BOOST_AUTO_TEST_CASE(creeping_is_given_up)
{
  // Steps of which not a hundredth is admissible, far from equilibrium: not the twenty that are allowed are made.
  Scalar problem = stiffening(10.);
  problem.largest_step = .005;
  const auto creeping = problem.solve(0.);
  BOOST_TEST((creeping.outcome == Outcome::diverged));
  BOOST_TEST(creeping.iterations == 3u);
  BOOST_TEST(creeping.residuals.size() == 4u);
  problem.largest_step = .3; // .03, .06, ...
  BOOST_TEST(problem.solve(0.).converged());
  // At the solution's door short steps are no failure.
  problem.largest_step = 1e-6;
  BOOST_TEST(problem.solve(2. - 5e-6).converged());
}

BOOST_AUTO_TEST_CASE(what_goes_to_and_fro_is_given_up)
{
  // About the solution Newton's method leads from u to -u on the square root; on a slightly higher power it comes
  // nearer by a quarter each time.
  for (const double exponent : {.5, .57})
  {
    Scalar power([=](const double u) { return 10. + std::copysign(std::pow(std::abs(u - 1.), exponent), u - 1.); },
                 [=](const double u) { return exponent * std::pow(std::abs(u - 1.), exponent - 1.); }, 10.);
    const auto result = power.solve(2., {"Line search=false"});
    BOOST_TEST((result.outcome == Outcome::diverged));
    BOOST_TEST(result.iterations == (exponent == .5 ? 8u : 20u));
    // It takes eight of them at least to tell, however few are allowed, and more where more are.
    for (const unsigned int most : {2u, 3u, 7u})
    {
      const std::string allowed = "Maximal iterations=" + std::to_string(most);
      BOOST_TEST(power.solve(2., {"Line search=false", allowed}).iterations == most);
    }
    BOOST_TEST(power.solve(2., {"Line search=false", "Maximal iterations=50"}).iterations >= 20u);
  }
}

BOOST_AUTO_TEST_CASE(rounds_of_corrections)
{
  Scalar problem = stiffening(10.);
  problem.n_corrections = 3;
  const NewtonResult done = problem.solve(0.);
  BOOST_TEST(done.converged());
  BOOST_TEST(done.rounds == 3u);
  const double u = problem.q[0];
  BOOST_TEST(std::abs(u + u * u * u - 10. * 1.1 * 1.1 * 1.1) < 1e-6);

  Scalar endless = stiffening(10.);
  endless.n_corrections = 100;
  const NewtonResult given_up = endless.solve(0., {"Maximal corrections=5"});
  BOOST_TEST((given_up.outcome == Outcome::not_corrected));
  BOOST_TEST(given_up.rounds == 6u);
}

BOOST_AUTO_TEST_CASE(corrections_close_to_equilibrium)
{
  // Asked for once in every iteration that ends between .1 and the tolerance of forces, 1e-6; not where no
  // correction is allowed.
  Scalar problem = stiffening(10.);
  const NewtonResult alone = problem.solve(0.);
  const auto is_close = [](const double residual) { return residual <= .1 && residual > 1e-6; };
  const auto n_close = std::count_if(alone.residuals.begin(), alone.residuals.end(), is_close);
  BOOST_TEST(n_close > 0);
  BOOST_TEST(problem.n_asked_early == n_close);
  BOOST_TEST(n_close < static_cast<long>(alone.iterations));
  problem.n_asked_early = 0;
  problem.solve(0., {"Maximal corrections=0"});
  BOOST_TEST(problem.n_asked_early == 0u);

  // They converge with the unknowns: the same solution as after a round of its own, in fewer iterations.
  Scalar early = stiffening(10.), late = stiffening(10.);
  early.n_early_corrections = late.n_corrections = 1;
  const NewtonResult with = early.solve(0.), after = late.solve(0.);
  BOOST_TEST((with.converged() && after.converged()));
  BOOST_TEST(early.load == late.load);
  BOOST_TEST(with.rounds == 0u);
  BOOST_TEST(after.rounds == 1u);
  BOOST_TEST(with.iterations < after.iterations);
  BOOST_TEST(std::abs(early.q[0] - late.q[0]) < 1e-6);
}

BOOST_AUTO_TEST_CASE(a_small_residual_alone_is_no_solution)
{
  Scalar problem = stiffening(10.);
  const auto at_once = problem.solve(0.);
  problem.n_inconsistent = 2;
  const auto later = problem.solve(0.);
  BOOST_TEST(later.converged());
  BOOST_TEST(later.iterations > at_once.iterations);
  BOOST_TEST(problem.n_inconsistent == 0u);
}

BOOST_AUTO_TEST_CASE(forces_that_do_not_balance_are_no_solution)
{
  Scalar problem = stiffening(10.);
  const auto at_once = problem.solve(0., {"Force tolerance=1e-3"});
  const double off = std::abs(problem.q[0] - 2.);
  BOOST_REQUIRE(off > 1e-8);
  problem.forces_left = [](const double u) { return 1e4 * std::abs(u - 2.); };
  const auto balanced = problem.solve(0., {"Force tolerance=1e-3"});
  BOOST_TEST(balanced.converged());
  BOOST_TEST(balanced.iterations > at_once.iterations);
  BOOST_TEST(std::abs(problem.q[0] - 2.) <= 5e-8);
  // Steps of round-off are the end, whatever is left.
  problem.forces_left = [](double) { return 6e-4; };
  BOOST_TEST(problem.solve(0.).converged());
  // A state that never comes to rest fails, and it is said what is left, however small the residual is.
  Scalar sticks([](const double u) { return u + std::copysign(1e-7, u - 2.); }, [](double) { return 1.; }, 2.);
  sticks.forces_left = problem.forces_left;
  const auto never = sticks.solve(0., {"Line search=false"});
  BOOST_TEST((never.outcome == Outcome::diverged));
  BOOST_TEST(never.imbalance == 6e-4);
  BOOST_TEST(never.residuals.back() < 1e-6);
  BOOST_TEST(never.iterations <= 40u);
  BOOST_TEST(sticks.solve(0., {"Line search=false", "Balance tolerance=1e-3"}).converged());
  // Far from equilibrium it is not the reason.
  sticks.slope = [](double) { return 1e3; };
  BOOST_TEST((sticks.solve(0.).outcome == Outcome::diverged));
  BOOST_TEST(sticks.solve(0.).imbalance == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
