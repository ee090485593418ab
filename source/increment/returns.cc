#include <deltaform/increment/returns.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    constexpr unsigned int most_states = 4; ///< a circle may lead through several

    bool same(const Vector &a, const Vector &b, const std::vector<double> &scale, const double tolerance)
    {
      for (unsigned int i = 0; i < scale.size(); ++i)
        if (!(std::abs(a[i] - b[i]) * scale[i] <= tolerance))
          return false;
      return true;
    }
  } // namespace


  bool Returns::come(const Vector &q, const std::vector<double> &scale, const double tolerance)
  {
    const bool returned = away_ && std::any_of(states_.begin(), states_.end(), [&](const Vector &state) {
                            return same(q, state, scale, tolerance);
                          });
    away_ = false;
    states_.push_back(q);
    if (states_.size() > most_states)
      states_.pop_front();
    return returned;
  }
} // namespace deltaform
