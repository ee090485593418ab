#pragma once

#include <deltaform/blanks/increment_size.h>
#include <deltaform/blanks/sheet_section.h>
#include <deltaform/increment/equations.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// What strategies and Increment see of a model: the equations of the next state, how an increment begins, and what
  /// it is judged by.
  class IncrementProblem : public Equations
  {
  public:
    /// Look for the state at @p time from the committed one; what was tried before is discarded. @param ratio of the
    /// length of this increment to that of the one before; 0: there is none that it continues
    virtual void begin(double time, double ratio) = 0;

    /// Let contact have a share of its stiffness at first. @return false if nothing can touch
    virtual bool soften() = 0;

    virtual const Vector &committed() const = 0;

    /// Values of the prescribed unknowns at the end of the increment, and which they are.
    virtual const Vector &prescribed() const = 0;
    virtual const std::vector<bool> &is_prescribed() const = 0;

    /// Forces below this are round-off.
    virtual double force_floor() const = 0;

    /// Of the step @p dq from the committed state to the one that was assembled last.
    virtual IncrementSize increment_size(const Vector &dq) const = 0;

    /// Cross-sections of a sheet in the state that was assembled last; none of a solid.
    virtual std::vector<SheetSection> trial_sections() const
    {
      return {};
    }

    /// Where penetration <= delta is broken in the state assembled last, in words; empty if it is kept.
    virtual std::string broken_promise() const = 0;

    /// Do forces of the last stage vanish in this increment?
    virtual bool releases_at_once() const = 0;

    /// "node 12 at r = 0.53, rotation", for messages; empty if the unknown is not one of a body.
    virtual std::string describe(DofIndex unknown) const = 0;
  };
} // namespace deltaform
