#pragma once

#include <deltaform/base/timers.h>
#include <deltaform/scene/forming_problem.h>
#include <deltaform/solver/condition.h>

#include <limits>
#include <string>

namespace deltaform
{
  /// Condition numbers of one tangent; NaN where unknown. Derivation and meaning: doc/theory/condition.md.
  struct ConditionNumbers
  {
    double raw = std::numeric_limits<double>::quiet_NaN(); ///< with contact, as assembled
    double scaled = std::numeric_limits<double>::quiet_NaN(); ///< after diagonal scaling in the contact frames
    double without_contact = std::numeric_limits<double>::quiet_NaN(); ///< on the complement of the rigid modes
    double digits_lost = std::numeric_limits<double>::quiet_NaN(); ///< by a direct solution
    unsigned int n_rigid = 0;
    std::string rigid_modes; ///< motions that the blank without contact does not resist
  };

  /// Computes condition numbers of the tangent of every n-th increment. Exists only where a scene asks for them.
  class ConditionReport
  {
  public:
    ConditionReport(unsigned int every, condition::Method method, Timers &timers);

    /// Is it the turn of this increment?
    bool due(unsigned int increment) const
    {
      return increment % every_ == 0;
    }

    /// Before the increment is solved: keep the tangent without contact terms of the last assembly.
    void watch(FormingProblem &problem);

    /// Of the converged but not yet committed state @p q of @p problem, which is not touched: the tangents are those of
    /// the last Newton iteration.
    ConditionNumbers measure(FormingProblem &problem, const Vector &q);

  private:
    unsigned int every_;
    condition::Method method_;
    Timers &timers_;
    Timers::Index timer_;
    condition::Matrix without_; ///< tangent of the last assembly, without contact
  };
} // namespace deltaform
