#include <deltaform/increment/increment.h>
#include <deltaform/increment/step_control.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/interruption.h>
#include <deltaform/process/ranks.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// No equilibrium. One whose penalty factors are not yet right is an equilibrium, and no other strategy helps.
    bool failed(const NewtonResult &result)
    {
      return !result.converged() && result.outcome != NewtonResult::Outcome::not_corrected;
    }

    /// How it began and how it ended says what went wrong; there may be hundreds between.
    std::string listed(const std::vector<double> &residuals)
    {
      constexpr std::size_t first = 3, last = 5;
      std::string result;
      for (std::size_t i = 0; i < residuals.size(); ++i)
        if (i < first || i + last >= residuals.size())
          result += (i == 0 ? "" : " ") + text::format(std::round(residuals[i] * 1e12) / 1e12);
        else if (i == first)
          result += " ...";
      return result;
    }
  } // namespace


  Ladder make_ladder(const std::vector<std::string> &names)
  {
    Ladder ladder;
    for (const auto &name : names)
      ladder.push_back(StrategyMakers::make(name));
    return ladder;
  }


  Ladder usual_ladder()
  {
    return make_ladder({"plain", "soft contact", "viscous", "viscous, a long way"});
  }


  Increment::Increment(IncrementProblem &problem, Newton &newton, const StepSettings &settings, Ladder ladder)
    : problem_(problem), newton_(newton), settings_(settings), ladder_(std::move(ladder))
  {
  }


  IncrementResult Increment::attempt(const IncrementStart &start, const Effort effort)
  {
    IncrementResult result;
    NewtonResult solved;
    bool any = false;
    const unsigned int linear_iterations = newton_.system().n_linear_iterations();
    for (const auto &strategy : ladder_)
    {
      if (strategy->least_effort() > effort || strategy->most_effort() < effort)
        continue;
      auto q = strategy->begin(problem_, start);
      if (!q)
        continue;
      any = true;
      result.q = std::move(*q);
      solved = strategy->solve(problem_, newton_, result.q);
      result.cost.iterations += solved.iterations;
      result.cost.rounds += solved.rounds;
      result.cost.correction_iterations += solved.correction_iterations;
      result.by_last_resort = strategy->least_effort() >= Effort::last_resorts;
      if (!failed(solved) || ranks::max(interruption::signal()) != 0)
        break;
    }
    if (!any)
    {
      result.rejected = Rejected{Rejected::Kind::not_solved, "no strategy applies to this increment"};
      return result;
    }
    result.cost.linear_iterations = newton_.system().n_linear_iterations() - linear_iterations;
    result.iterations_to_equilibrium = result.cost.iterations - solved.correction_iterations;

    if (!failed(solved))
      if (const std::string broken = problem_.broken_promise(); !broken.empty())
        result.rejected = Rejected{Rejected::Kind::promise_broken, broken};
    solved.iterations = result.cost.iterations;
    if (!result.rejected && !solved.converged())
      result.rejected = Rejected{Rejected::Kind::not_solved, explain(solved), listed(solved.residuals)};
    if (!result.rejected)
    {
      const bool may_snap = effort == Effort::all && (result.by_last_resort || problem_.releases_at_once());
      result.rejected = too_large(start.length, may_snap, result);
    }
    return result;
  }


  std::optional<Rejected> Increment::too_large(const double length, const bool may_snap, IncrementResult &result) const
  {
    const auto refused = [](const char *what, const double value, const Point2 &place, const double allowed) {
      return Rejected{Rejected::Kind::too_large,
                      std::string("the largest ") + what + " increment is " + text::rounded(value) +
                        ", at R0 = " + text::rounded(place[0]) + ", Z0 = " + text::rounded(place[1]) + "; allowed are " +
                        text::rounded(allowed) + " (Solver/Largest " + what + " increment)"};
    };
    Vector dq = result.q;
    dq -= problem_.committed();
    const auto [strain, rotation, strained, turned] = problem_.increment_size(dq);
    // A new equilibrium at the same time is as far as the mesh was wrong, and no shorter increment brings it closer: it
    // is said.
    if (length <= 0.)
    {
      result.strain_at_rest = strain > settings_.largest_strain ? strain : 0.;
      return std::nullopt;
    }
    // Where the blank snaps through, a shorter increment does not make the way shorter; but what is strained much too
    // far in one step has been on another path.
    constexpr double far = 3.;
    if (strain > (may_snap ? far : 1.) * settings_.largest_strain)
    {
      Rejected rejected = refused("strain", strain, strained, settings_.largest_strain);
      rejected.sections = problem_.trial_sections();
      return rejected;
    }
    if (rotation > settings_.largest_rotation && !may_snap)
      return refused("rotation", rotation, turned, settings_.largest_rotation);
    // What a last resort has led to is another equilibrium if it is far, allowed or not.
    const double near = result.by_last_resort ? .5 : 1.;
    if (strain > near * settings_.largest_strain)
      result.snap.strain = strain;
    if (rotation > near * settings_.largest_rotation)
      result.snap.rotation = rotation;
    if (strain <= settings_.largest_strain && rotation <= settings_.largest_rotation)
      result.size = std::max(strain / settings_.largest_strain, rotation / settings_.largest_rotation);
    return std::nullopt;
  }


  std::string Increment::explain(const NewtonResult &result) const
  {
    std::string where;
    if (const std::string name = result.worst_dof == invalid_index ? "" : problem_.describe(result.worst_dof);
        !name.empty())
      where = " (largest residual at " + name + ")";
    switch (result.outcome)
    {
    case NewtonResult::Outcome::singular:
      if (const std::string failure = newton_.system().linear_failure(); !failure.empty())
        return "the linear solver did not converge: " + failure +
               " (Solver/Maximal linear iterations, Solver/Linear solver tolerance). Try Linear solver = mumps" + where;
      return "the tangent is singular: a part of the blank is free to move, or a limit load is reached" + where;
    case NewtonResult::Outcome::inadmissible:
      return std::string(result.status.cause) + ", cell " + std::to_string(result.status.place);
    case NewtonResult::Outcome::not_corrected:
      return "the corrections of the penalty factors did not end after " + std::to_string(result.rounds) + " rounds" +
             where;
    default:
      break;
    }
    const std::string iterations = "Newton did not converge in " + std::to_string(result.iterations) + " iterations";
    if (result.imbalance > newton_.settings().balance_tolerance)
      return iterations + ": the forces of tools, supports and loads still leave " +
             text::percent(result.imbalance) + " of the largest of them unbalanced (Solver/Balance tolerance)" + where;
    return iterations + where;
  }
} // namespace deltaform
