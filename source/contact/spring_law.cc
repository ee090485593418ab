#include "spring_law.h"

#include <cmath>
#include <limits>

namespace deltaform
{
  NormalResponse SpringLaw::spring(const ContactPointState &state, const double gap)
  {
    NormalResponse response;
    response.touching = true;
    response.force = state.shift - state.penalty_factor * gap;
    response.derivative = -state.penalty_factor;
    return response;
  }


  NormalResponse
  SpringLaw::decide(const ContactPointState &state, const double left, const NormalSituation &situation) const
  {
    if (!std::isfinite(left))
      return {};
    constexpr double certainly = std::numeric_limits<double>::infinity();
    if (situation.foreseen)
      return *situation.foreseen ? respond(state, left, certainly) : NormalResponse();
    // The gap at the start is wrong by what extrapolation leaves out, and an equilibrium that hangs on a few nodes is
    // lost if one of them lets go for that: the step then goes where nothing holds the blank.
    if (situation.held && state.multiplier > 0)
      return respond(state, left, certainly);
    return respond(state, left, state.multiplier);
  }


  NormalResponse SpringLaw::respond(const ContactPointState &state, const NormalSituation &situation) const
  {
    // The face, a spring in series, takes the rest of the gap.
    const double share = state.spring_share(situation.compliance);
    const double left = share * (situation.gap + situation.compliance * state.shift);
    NormalResponse response = decide(state, left, situation);
    response.derivative *= share;
    response.gap = response.touching ? left : situation.gap;
    if (situation.share < 1)
    {
      response.force *= situation.share;
      response.derivative *= situation.share;
    }
    return response;
  }


  bool SpringLaw::uses_penalty() const
  {
    return true;
  }


  bool SpringLaw::is_free_when_clear(const ContactPointState &state) const
  {
    return !(state.multiplier > 0) && !(state.shift > 0);
  }


  bool SpringLaw::is_concerned(const ContactPointState &state) const
  {
    return state.gap <= 0 || state.multiplier > 0;
  }


  double SpringLaw::estimate(const ContactPointState &state, const double opening, const double share) const
  {
    if (!state.touching)
      return 0.;
    const double factor = share * state.penalty_factor;
    return state.shift - factor * (state.gap + state.spring_share(state.compliance) * opening);
  }


  bool SpringLaw::foresee(const ContactPointState &state, const double opening, const double compliance) const
  {
    // The gap of a touching point is what the face leaves of it.
    const double gap = state.gap + (state.touching ? state.spring_share(compliance) : 1.) * opening;
    return state.penalty_factor > 0 ? state.penalty_factor * gap <= state.shift : gap <= 0;
  }
} // namespace deltaform
