#include <deltaform/increment/scaled_norm.h>
#include <deltaform/increment/step_search.h>

#include <limits>
#include <optional>
#include <utility>

namespace deltaform
{
  namespace
  {
    // As close to equilibrium the tangent of the blank is good for all sets that the solve may meet; so they are tried
    // with it.
    constexpr double near_equilibrium = 3e-3;

    // doc/decisions/README.md, "Sets that lead to each other"
    constexpr double share_of_step = .25; ///< that becomes the radius
    constexpr unsigned int most_radii = 4;
  } // namespace


  StepSearch::StepSearch(Equations &equations,
                         System &system,
                         const NewtonSettings &settings,
                         const std::vector<double> &scale,
                         const std::vector<bool> &is_prescribed,
                         Timers &timers,
                         const bool damps,
                         SetLimit *limit)
    : equations_(equations), system_(system), scale_(scale), timers_(timers),
      timer_solve_(timers.section("11 factorization and solve")), has_sets_(equations.active_set() != nullptr),
      damps_(damps), d_(scale.size()), sets_(equations, system, settings, scale, is_prescribed, limit)
  {
  }


  bool StepSearch::find(const Start &start, const Vector &increments)
  {
    increments_ = increments;
    return find_again(start);
  }


  bool StepSearch::find_again(const Start &start)
  {
    searched_ = has_sets_ && (start.is_first || start.residual <= near_equilibrium);
    bool found = find_within_radius(start, searched_, false);
    for (unsigned int n = 0; found && n < most_radii && searched_ && sets_.lead_to_each_other(); ++n)
    {
      if (!damps_ || start.is_moving || !damping_.shorten(start.residual, share_of_step * sets_.longer_step()))
        break;
      found = find_within_radius(start, true, true);
    }
    return found;
  }


  bool StepSearch::find_without_set(const Start &start)
  {
    searched_ = false;
    return find_within_radius(start, false, false);
  }


  bool StepSearch::find_within_radius(const Start &start, const bool finds_set, const bool is_other_set)
  {
    const SetSearch::Solve how = [this](const double shift) { return solve(shift); };
    const auto find_set = [&] {
      return sets_.run(start.q, d_, {start.residual, start.magnitude, radius_search_.stiffness()}, how);
    };
    // Another set may make the step longer.
    return find_direction(start, is_other_set) && (!finds_set || find_set()) &&
           (RadiusSearch::is_within(radius(start), length()) || find_direction(start, true));
  }


  bool StepSearch::find_direction(const Start &start, const bool is_other_set)
  {
    bool again = is_other_set;
    const auto length_at = [&](const double mu) -> std::optional<double> {
      // The same tangent of the blank, contact as it is now.
      if (std::exchange(again, true) && !equations_.assemble_foreseen(start.q) && !assemble(start))
        return std::nullopt;
      if (mu > 0.)
        system_.add_to_diagonal(mu, scale_);
      // A free rigid motion, or a blank that contact does not yet hold: a shifted matrix still gives a direction.
      if (!solve(0.) && !(assemble(start) && solve(1e-6)))
        return std::nullopt;
      return length();
    };
    return radius_search_.find(radius(start), start.residual * start.magnitude, length_at);
  }


  bool StepSearch::assemble(const Start &start)
  {
    status_ = equations_.assemble(start.q, true);
    return status_.good();
  }


  bool StepSearch::solve(const double shift)
  {
    Timers::Scope timer(timers_, timer_solve_);
    return system_.factorize(shift) && system_.solve(increments_, d_);
  }


  bool StepSearch::is_bound(const Start &start) const
  {
    return radius(start) < std::numeric_limits<double>::infinity();
  }


  double StepSearch::radius(const Start &start) const
  {
    return damps_ && !start.is_moving ? damping_.radius(start.residual) : std::numeric_limits<double>::infinity();
  }


  double StepSearch::length() const
  {
    return scaled_norm(d_, scale_);
  }
} // namespace deltaform
