// A search for the set of active inequalities without an end: a body that softens touches a spring that pushes it off.
#include "sets_problem.h"

#include <boost/test/unit_test.hpp>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// Residual -u - 1 of the first unknown, which a spring of stiffness 3 acts on where it is not positive: alone it
  /// goes to -1, with the spring to .5. A second unknown, by itself, carries a load.
  class Softening : public SetsProblem
  {
  public:
    explicit Softening(const double load_of_other)
      : load(load_of_other), system(full_pattern(2), 0, "klu")
    {
    }

    Status assemble(const Vector &u, const bool tangent) override
    {
      system.clear(tangent);
      const DofIndex dofs[] = {0, 1};
      const double body[] = {-u[0] - 1., u[1] - load}, block[] = {-1., 0., 0., 1.};
      system.add(dofs, 2, tangent ? block : nullptr, body);
      if (tangent)
        BOOST_TEST(system.keep());
      touches = u[0] <= 0;
      add_spring(u, tangent);
      return {};
    }

    void add_spring(const Vector &u, const bool tangent)
    {
      const DofIndex dof = 0;
      const double stiffness = 3., force = stiffness * u[0];
      if (touches)
        system.add(&dof, 1, tangent ? &stiffness : nullptr, &force);
    }

    bool assemble_foreseen(const Vector &u) override
    {
      ++n_sets;
      touches = next;
      system.go_back();
      add_spring(u, true);
      return true;
    }

    bool foresee(const Vector &q, const Vector &d) override
    {
      next = q[0] + d[0] <= 0;
      return next != touches;
    }

    std::size_t signature() const override
    {
      return touches;
    }

    void prepare_step(const Vector &d) override
    {
      if (!step.empty())
        return;
      step = {d[0], d[1]};
      touches_in_step = touches;
      n_sets_of_step = n_sets;
    }

    /// @param force_floor large against the forces: close to equilibrium
    void solve(const double force_floor = 0.)
    {
      const std::vector<double> scale(2, 1.), size(2, 1e-6);
      Timers timers;
      Vector u(2);
      const Vector start = u;
      Newton newton(*this, system, newton_settings({"Maximal iterations=2"}), scale, size, timers);
      newton.solve(u, start, std::vector<bool>(2, false), start, force_floor);
    }

    double load;
    bool touches = true, next = true, touches_in_step = true;
    unsigned int n_sets = 0, n_sets_of_step = 0; ///< all; of the first step
    std::vector<double> step; ///< the first one
    System system;
  };
} // namespace


BOOST_AUTO_TEST_SUITE(sets_to_and_fro)

BOOST_AUTO_TEST_CASE(two_sets_that_lead_to_each_other_are_left)
{
  Softening body(1.);
  body.solve();
  // The first step knows the spring, the first set does not, and so on: three of each.
  BOOST_TEST(body.n_sets_of_step == 6u);
  // It is the step with the spring, as that of any even number of sets.
  BOOST_TEST(std::abs(body.step[0] - .5) < 1e-14);
  BOOST_TEST(std::abs(body.step[1] - 1.) < 1e-14);
}

BOOST_AUTO_TEST_CASE(close_to_equilibrium_a_shorter_step_is_for_one_that_leads_to_itself)
{
  Softening body(0.);
  body.solve(1e4);
  // The spring is left along its force. The longer step is -1, without it, so the radius .25 and the damping 4 at most.
  BOOST_TEST(std::abs(body.step[0] - 1. / 3.) < 1e-12);
  BOOST_TEST(!body.touches_in_step);
}

BOOST_AUTO_TEST_CASE(a_change_of_no_weight_ends_the_search)
{
  // Its forces are a millionth of those that are out of balance.
  Softening body(1e6);
  body.solve();
  BOOST_TEST(body.n_sets_of_step == 2u);
  BOOST_TEST(std::abs(body.step[1] - 1e6) < 1e-8);
}

BOOST_AUTO_TEST_SUITE_END()
