// A beam that lies on unilateral springs and is lifted at its end peels off. With a linear body the solve is over when
// the set of touching points is found, and that takes no assembly of the body.
#include "sets_problem.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// Energy EI/2 sum (u_{i-1} - 2 u_i + u_{i+1})^2 + k/2 sum min(u_i, 0)^2 - sum p_i u_i, the last u lifted by a force.
  class Beam : public SetsProblem
  {
  public:
    static constexpr unsigned int n = 80;
    static constexpr double bending = 1e3, weight = .01;

    Beam(const bool looks_ahead, const double stiffness, const bool lets_neighbours_go)
      : spring(stiffness), touches(n, true), foresees(looks_ahead), peels(lets_neighbours_go),
        system(pattern(), 0, "klu")
    {
    }

    static dealii::DynamicSparsityPattern pattern()
    {
      dealii::DynamicSparsityPattern result(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = i < 2 ? 0 : i - 2; j < std::min(n, i + 3); ++j)
          result.add(i, j);
      return result;
    }

    double typical_length() const override
    {
      return 1e-3;
    }

    Status assemble(const Vector &u, const bool tangent) override
    {
      ++n_assemblies;
      system.clear(tangent);
      for (DofIndex i = 1; i + 1 < n; ++i)
      {
        const DofIndex dofs[] = {i - 1, i, i + 1};
        const double c[] = {1, -2, 1}, moment = bending * (u[i - 1] - 2 * u[i] + u[i + 1]);
        double force[3], block[9];
        for (unsigned int a = 0; a < 3; ++a)
        {
          force[a] = c[a] * moment;
          for (unsigned int b = 0; b < 3; ++b)
            block[3 * a + b] = bending * c[a] * c[b];
        }
        system.add(dofs, 3, tangent ? block : nullptr, force);
      }
      for (DofIndex i = 0; i < n; ++i)
      {
        const double force = i + 1 < n ? weight : -lift;
        system.add(&i, 1, nullptr, &force);
      }
      if (tangent)
        BOOST_TEST(system.keep());
      std::vector<bool> now(n);
      for (unsigned int i = 0; i < n; ++i)
        now[i] = multiplier.empty() || !(multiplier[i] > 0) ? u[i] <= 0 : multiplier[i] >= spring / 100 * u[i];
      other = now != touches;
      touches = now;
      add_springs(u, tangent);
      return {};
    }

    void add_springs(const Vector &u, const bool tangent)
    {
      for (DofIndex i = 0; i < n; ++i)
        if (touches[i])
        {
          const double force = spring * u[i], stiffness = spring;
          system.add(&i, 1, tangent ? &stiffness : nullptr, &force);
        }
      at = u;
    }

    bool assemble_foreseen(const Vector &u) override
    {
      if (!foresees)
        return false;
      ++n_sets;
      touches = next;
      system.go_back();
      add_springs(u, true);
      return true;
    }

    bool foresee(const Vector & /*q*/, const Vector &d) override
    {
      next.resize(n);
      at_end = at;
      at_end += d;
      for (unsigned int i = 0; i < n; ++i)
        next[i] = at_end[i] <= 0;
      return next != touches;
    }

    void peel(const unsigned int reach) override
    {
      ++n_peelings;
      for (unsigned int i = 0; i < n; ++i)
        if (peels && touches[i] && at_end[i] > 0)
          for (unsigned int k = i - std::min(i, reach); k <= i + reach && k < n; ++k)
            next[k] = false;
    }

    std::size_t signature() const override
    {
      return std::hash<std::vector<bool>>()(touches);
    }

    void prepare_step(const Vector &d) override
    {
      multiplier.assign(n, 0.);
      for (unsigned int i = 0; i < n; ++i)
        if (touches[i])
          multiplier[i] = -spring * (at[i] + d[i]);
    }

    bool changed() const override
    {
      return other;
    }

    bool consistent(const double tension) const override
    {
      for (unsigned int i = 0; i < n; ++i)
        if (touches[i] && spring * at[i] > tension)
          return false;
      return true;
    }

    double lift = 0., spring;
    std::vector<bool> touches, next;
    std::vector<double> multiplier;
    bool foresees, peels, other = false;
    unsigned int n_assemblies = 0, n_sets = 0, n_peelings = 0;
    Vector at, at_end;
    System system;
  };

  /// Lies on all springs, then is lifted more.
  struct Lifted
  {
    explicit Lifted(const bool foresees, const double spring = 1e2, const bool peels = true)
      : beam(foresees, spring, peels), u(Beam::n)
    {
      beam.lift = .1;
      BOOST_TEST(solve().converged());
      beam.n_sets = beam.n_peelings = 0;
      beam.lift = .25;
      result = solve();
    }

    NewtonResult solve()
    {
      const NewtonSettings settings = newton_settings({"Maximal iterations=200", "Force tolerance=1e-12"});
      // Forces are small against those that round-off is measured by, so that the solve begins close to equilibrium.
      constexpr double force_floor = 1e3;
      const std::vector<double> scale(Beam::n, 1.), size(Beam::n, 1e-6);
      const std::vector<bool> free(Beam::n, false);
      const Vector start = u;
      Timers timers;
      Newton newton(beam, beam.system, settings, scale, size, timers);
      return newton.solve(u, start, free, start, force_floor);
    }

    /// Largest force that is out of balance with springs that only push.
    double unbalanced()
    {
      beam.assemble(u, false);
      double largest = 0.;
      for (unsigned int i = 0; i < Beam::n; ++i)
      {
        const double acting = beam.touches[i] ? beam.spring * u[i] : 0., right = beam.spring * std::min(u[i], 0.);
        largest = std::max(largest, std::abs(beam.system.residual()[i] - acting + right));
      }
      return largest;
    }

    Beam beam;
    Vector u;
    NewtonResult result;
  };
} // namespace


BOOST_AUTO_TEST_SUITE(peeling)

BOOST_AUTO_TEST_CASE(a_beam_that_peels_off_takes_no_further_assembly_of_the_body)
{
  Lifted slowly(false), at_once(true);
  BOOST_TEST(slowly.result.converged());
  BOOST_TEST(at_once.result.converged());
  BOOST_TEST(slowly.unbalanced() < 1e-8);
  BOOST_TEST(at_once.unbalanced() < 1e-8);
  for (unsigned int i = 0; i < Beam::n; ++i)
    BOOST_TEST(std::abs(at_once.u[i] - slowly.u[i]) < 1e-9);
  BOOST_TEST(slowly.result.iterations >= 8u);
  BOOST_TEST(at_once.result.iterations <= 2u);
  BOOST_TEST(at_once.beam.n_sets > 3u);
}

// On stiff springs it loses one point after the other, thirty of them; the twenty-first set loses more.
BOOST_AUTO_TEST_CASE(long_searches_let_neighbours_go_as_well)
{
  Lifted point_by_point(true, 1e6, false), faster(true, 1e6);
  BOOST_TEST(point_by_point.result.converged());
  BOOST_TEST(faster.result.converged());
  for (unsigned int i = 0; i < Beam::n; ++i)
    BOOST_TEST(std::abs(faster.u[i] - point_by_point.u[i]) < 1e-9);
  BOOST_TEST(point_by_point.beam.n_sets >= 30u);
  BOOST_TEST(faster.beam.n_peelings == 1u);
  BOOST_TEST(faster.beam.n_sets + 2 <= point_by_point.beam.n_sets);
}

BOOST_AUTO_TEST_SUITE_END()
