#pragma once

#include "convergence.h"

#include <deltaform/increment/increment.h>
#include <deltaform/increment/step_control.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/section.h>

#include <cmath>
#include <string>
#include <vector>

namespace deltaform
{
  namespace testing
  {
    /// R(u) = u (u - 1) (u - 2) - t: its limit point is at u = 1 - 1/sqrt(3), t = .3849; beyond it only u > 2 is left.
    class Arch : public IncrementProblem
    {
    public:
      Arch()
        : system(full_pattern(2), 0, "klu"), q(2), goal(2)
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
        const double u = state[0];
        if (is_stiff && u > first_touch)
          return Status::shorten("too stiff");
        const DofIndex dof = 0, end = 1;
        const double one = 1., zero = 0.;
        system.add(&end, 1, tangent ? &one : nullptr, &zero);
        const double force = is_free ? 0. : u * (u - 1.) * (u - 2.), load = -time;
        const double slope = is_free ? 0. : 3. * u * u - 6. * u + 2.;
        system.add(&dof, 1, tangent ? &slope : nullptr, &force);
        system.add(&dof, 1, nullptr, &load);
        return {};
      }

      double limit_step(const Vector &, Vector &) const override
      {
        return share_of_steps;
      }

      double imbalance() const override
      {
        return forces_left;
      }

      ActiveSet *active_set() override
      {
        return nullptr;
      }

      unsigned int correct(const Vector & /*q*/) override
      {
        if (n_corrections == 0)
          return 0;
        --n_corrections;
        return 1;
      }

      void begin(const double the_time, double) override
      {
        time = the_time;
        ++n_begun;
        is_stiff = touches;
      }

      bool soften() override
      {
        if (!touches)
          return false;
        is_stiff = false;
        is_soft = true;
        return true;
      }

      const Vector &committed() const override
      {
        return q;
      }
      const Vector &prescribed() const override
      {
        return goal;
      }
      const std::vector<bool> &is_prescribed() const override
      {
        return held;
      }
      double force_floor() const override
      {
        return 0.;
      }
      IncrementSize increment_size(const Vector &dq) const override
      {
        return {strain, std::abs(dq[0]), Point2(.25, -.5), Point2(.75, 1.)};
      }
      std::string broken_promise() const override
      {
        return broken;
      }
      bool releases_at_once() const override
      {
        return false;
      }
      std::string describe(const DofIndex unknown) const override
      {
        return unknown == 0 ? "crown" : "end";
      }

      System system;
      Vector q, goal;
      std::vector<bool> held{false, true};
      std::vector<double> visited;
      double time = 0., strain = 0.;
      double share_of_steps = 1.; ///< that is admissible
      double forces_left = 0.;
      double first_touch = .01; ///< where a stiff first touch begins
      bool touches = false, is_stiff = false, is_soft = false;
      bool is_free = false; ///< nothing but the load
      unsigned int n_begun = 0, n_corrections = 0;
      std::string broken;
    };

    /// An arch, and what solves it.
    struct ArchFixture
    {
      explicit ArchFixture(const std::vector<std::string> &entries = {})
        : tree(ParameterTree::parse("", "test", entries)), section(tree.root()), steps(section),
          settings(newton_settings(entries)), scale(2, 1.), size(2, 10.),
          newton(problem, problem.system, settings, scale, size, timers), increment(problem, newton, steps)
      {
      }

      IncrementResult to(const double time, const Effort effort)
      {
        return increment.attempt({time, time, true, predictor}, effort);
      }

      ParameterTree tree;
      Section section;
      StepSettings steps;
      NewtonSettings settings;
      std::vector<double> scale, size;
      Timers timers;
      Arch problem;
      Newton newton;
      Increment increment;
      Predictor predictor;
    };
  } // namespace testing
} // namespace deltaform
