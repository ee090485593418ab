// A search for the set of active inequalities that comes to no end: its last set is a guess.
#include "sets_problem.h"

#include <deltaform/increment/set_limit.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// A spring of stiffness 1 under a load of 1. Each set that is foreseen leads to another one and takes most of the
  /// stiffness away: its step is 5 or 10 in place of 1.
  class Endless : public SetsProblem
  {
  public:
    /// @param last_is_right the set that the search ends with takes no stiffness away
    explicit Endless(const bool last_is_right)
      : last_is_right_(last_is_right), system(full_pattern(1), 0, "klu")
    {
    }

    Status assemble(const Vector &u, const bool tangent) override
    {
      ++n_assemblies;
      system.clear(tangent);
      const DofIndex dof = 0;
      const double stiffness = 1., force = u[0] - 1.;
      system.add(&dof, 1, tangent ? &stiffness : nullptr, &force);
      if (tangent)
        BOOST_TEST(system.keep());
      return {};
    }

    bool assemble_foreseen(const Vector & /*u*/) override
    {
      ++n_sets;
      system.go_back();
      const DofIndex dof = 0;
      const double taken = n_sets % 2 == 0 ? .9 : .8, force = 0.;
      const double stiffness = last_is_right_ && n_sets == 60 ? 0. : -taken;
      system.add(&dof, 1, &stiffness, &force);
      return true;
    }

    bool foresee(const Vector & /*q*/, const Vector & /*d*/) override
    {
      return true;
    }

    std::size_t signature() const override
    {
      return n_sets;
    }

    void prepare_step(const Vector &d) override
    {
      steps.push_back(d[0]);
    }

    NewtonResult solve(SetLimit *limit = nullptr)
    {
      const std::vector<double> scale(1, 1.), size(1, 1e-6);
      Timers timers;
      constexpr double force_floor = 1e3; // by which both residuals are measured
      Vector u(1);
      const Vector start = u;
      Newton newton(*this, system, newton_settings({"Maximal iterations=5"}), scale, size, timers);
      if (limit != nullptr)
        newton.limit_sets(*limit);
      return newton.solve(u, start, std::vector<bool>(1, false), start, force_floor);
    }

    unsigned int n_assemblies = 0, n_sets = 0;
    std::vector<double> steps;

  private:
    bool last_is_right_;

  public:
    System system;
  };
} // namespace


BOOST_AUTO_TEST_SUITE(endless_sets)

BOOST_AUTO_TEST_CASE(a_guess_that_leads_to_a_larger_residual_is_not_followed)
{
  Endless body(false);
  const NewtonResult result = body.solve();
  BOOST_TEST(result.converged());
  // The step of the last set, 10, and that of the set at its start; the next iteration has nothing left to do.
  BOOST_TEST_REQUIRE(body.steps.size() >= 2u);
  BOOST_TEST(std::abs(body.steps[0] - 10.) < 1e-12);
  BOOST_TEST(std::abs(body.steps[1] - 1.) < 1e-12);
  BOOST_TEST(result.residuals[1] < 1e-12);
}

BOOST_AUTO_TEST_CASE(one_that_leads_to_a_smaller_residual_is)
{
  Endless body(true);
  BOOST_TEST(body.solve().converged());
  BOOST_TEST_REQUIRE(!body.steps.empty());
  BOOST_TEST(std::abs(body.steps[0] - 1.) < 1e-12);
  if (body.steps.size() > 1)
    BOOST_TEST(std::abs(body.steps[1]) < 1e-12);
}

BOOST_AUTO_TEST_CASE(it_ends_earlier_where_few_sets_are_better)
{
  SetLimit limit;
  Endless many(false);
  BOOST_TEST(many.solve(&limit).converged());
  BOOST_TEST(many.n_sets >= SetLimit::many);
  // What the search has met is known, and few sets are tried in the next block.
  for (unsigned int k = 0; k < 28; ++k)
  {
    if (k > 0)
      limit.met(SetLimit::many, false);
    limit.accept(1., 1);
  }
  BOOST_TEST_REQUIRE(limit.most() == SetLimit::few);
  Endless few(false);
  BOOST_TEST(few.solve(&limit).converged());
  BOOST_TEST(few.n_sets < 2 * SetLimit::few + 2);
}

BOOST_AUTO_TEST_SUITE_END()
