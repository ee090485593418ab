#include <deltaform/increment/scaled_norm.h>
#include <deltaform/increment/set_search.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  namespace
  {
    // doc/decisions/README.md, "Sets for each tangent"
    constexpr unsigned int sets_before_peeling = 20, sets_between_peelings = 10, peeled_places = 2;
    constexpr unsigned int most_returns_of_a_set = 2; ///< the first may be due to points that had not been projected

    // A step is good enough if the linear equations with the set that it leads to hold up to this share of the
    // residual, or of the force tolerance.
    constexpr double share_of_residual = 1e-4, share_of_tolerance = .01;
  } // namespace


  SetSearch::SetSearch(Equations &equations,
                       System &system,
                       const NewtonSettings &settings,
                       const std::vector<double> &scale,
                       const std::vector<bool> &is_prescribed,
                       SetLimit *limit)
    : equations_(equations), system_(system), force_tolerance_(settings.force_tolerance), scale_(scale),
      is_prescribed_(is_prescribed), limit_(limit), linear_(scale.size())
  {
  }


  bool SetSearch::run(const Vector &q, const Vector &d, const Place &place, const Solve &solve)
  {
    std::vector<std::size_t> sets;
    const bool found = meet_sets(q, d, place, solve, sets);
    if (limit_ != nullptr)
      limit_->met(static_cast<unsigned int>(sets.size()), !is_guess_ && !lead_to_each_other_);
    return found;
  }


  bool SetSearch::meet_sets(const Vector &q,
                            const Vector &d,
                            const Place &place,
                            const Solve &solve,
                            std::vector<std::size_t> &sets)
  {
    is_guess_ = lead_to_each_other_ = false;
    length_ = scaled_norm(d, scale_);
    ActiveSet &active_set = *equations_.active_set();
    const unsigned int most = limit_ != nullptr ? limit_->most() : SetLimit::many;
    while (sets.size() < most && active_set.foresee(q, d))
    {
      // A zone that touches grows wherever points would penetrate, but peels off at its ends only, a place in a set.
      if (sets.size() >= sets_before_peeling && sets.size() % sets_between_peelings == 0)
        active_set.peel(peeled_places);
      if (!equations_.assemble_foreseen(q))
        return true;
      if (place.damping > 0.)
        system_.add_to_diagonal(place.damping, scale_);
      if (!sets.empty() && solves_linear_equations(d, place))
        return true;
      // Where the tangent is indefinite (a blank that snaps), two sets may lead to each other. The step is then that
      // of the one that an even number of sets ends with.
      const std::size_t set = active_set.signature();
      const bool goes_to_and_fro = std::count(sets.begin(), sets.end(), set) >= most_returns_of_a_set;
      sets.push_back(set);
      if (!solve(0.) && !(equations_.assemble_foreseen(q) && solve(1e-6)))
        return false;
      length_before_ = std::exchange(length_, scaled_norm(d, scale_));
      lead_to_each_other_ = goes_to_and_fro && sets.size() % 2 == 0;
      if (lead_to_each_other_)
        return true;
    }
    is_guess_ = sets.size() == most;
    return true;
  }


  bool SetSearch::solves_linear_equations(const Vector &d, const Place &place)
  {
    system_.linear_residual(d, linear_);
    double square = 0.;
    for (unsigned int i = 0; i < scale_.size(); ++i)
      if (!is_prescribed_[i])
        square += (linear_[i] / scale_[i]) * (linear_[i] / scale_[i]);
    const double enough = std::max(share_of_residual * place.residual, share_of_tolerance * force_tolerance_);
    return std::sqrt(square) <= enough * place.magnitude;
  }
} // namespace deltaform
