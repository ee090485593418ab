#include <deltaform/contact/normal_law.h>

#include <algorithm>

namespace deltaform
{
  bool NormalLaw::is_solution(const ContactPointState &state, const double allowed_tension, const bool /*final*/) const
  {
    return !state.touching || !(state.force < -std::max(allowed_tension, weight(state) * state.tolerance()));
  }
} // namespace deltaform
