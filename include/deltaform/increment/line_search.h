#pragma once

#include <functional>
#include <optional>

namespace deltaform
{
  /**
   * A search along a Newton step d that made the residual grow. The potential falls as long as the work of the residual
   * along the step, w(a) = d.R(q + a d), is negative: a few steps of the Illinois variant of regula falsi go for the
   * root of w. It is enough that w has become small against w(0).
   */
  class LineSearch
  {
  public:
    /// w at a factor, where the state is left; nothing if the laws cannot be evaluated there.
    using Work = std::function<std::optional<double>(double factor)>;

    /**
     * @param factor     of the step that was taken; no less than a fiftieth of it is tried: with friction the step need
     * not descend at all, and steps that are shorter lead nowhere
     * @param work_start w(0)
     * @param work_end   w at the factor
     * @param share      of |w(0)| that w may be
     * @return the factor where the state is left
     */
    double search(double factor, double work_start, double work_end, double share, const Work &work_at);

    /// How often w was asked for.
    unsigned int n_evaluations() const
    {
      return n_evaluations_;
    }

  private:
    static constexpr unsigned int most_evaluations = 6;
    unsigned int n_evaluations_ = 0;
  };
} // namespace deltaform
