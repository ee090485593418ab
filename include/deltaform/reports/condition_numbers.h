#pragma once

#include <deltaform/model/model.h>
#include <deltaform/process/journal.h>
#include <deltaform/process/timers.h>
#include <deltaform/reports/columns.h>
#include <deltaform/reports/observer.h>
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
  class ConditionReport : public Observer
  {
  public:
    ConditionReport(unsigned int every, condition::Method method, Journal &journal, Timers &timers);

    Turn turn() const override
    {
      return Turn::measures;
    }

    void before(const Model &model, unsigned int number) override;

    bool wants_tangent() const override
    {
      return due_;
    }

    /// Keeps that of the last assembly.
    void tangent_without_contact(const System &system) override;

    /// Measures the converged but not yet committed state, which is not touched: the tangents are those of the last
    /// Newton iteration.
    void solved(const Model &model, const System &system, const Vector &q) override;

    void accepted(const AcceptedIncrement &increment) override;

    /// Columns of the numbers that @p report has measured last; it must live longer. Null: for their names only.
    static void describe(Columns &columns, const ConditionReport *report);

  private:
    ConditionNumbers measure(const Model &model, const System &system, const Vector &q);

    unsigned int every_;
    condition::Method method_;
    Journal &journal_;
    Timers &timers_;
    Timers::Index timer_;
    bool due_ = false;
    ConditionNumbers numbers_; ///< of the last increment; unknown if it was none to measure
    condition::Matrix without_; ///< tangent of the last assembly, without contact
  };
} // namespace deltaform
