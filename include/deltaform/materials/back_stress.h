#pragma once

#include <deltaform/materials/yield_surface.h>

#include <array>
#include <string>

namespace deltaform
{
  /// The backstress at the end of an increment, with its derivatives.
  struct BackStressEnd
  {
    Mandel value; ///< backstress alpha (Kirchhoff stress)
    std::array<double, 16> by_relative_stress; ///< d alpha/d xi at fixed x, 4 x 4, row-major (1)
    Mandel by_flow; ///< d alpha/dx at fixed xi (stress)
  };


  /**
   * Kinematic hardening: q(stress - alpha) = flow stress, with alpha a function of history. With xi = stress - alpha at
   * the end of the increment and x the growth of the equivalent plastic strain, the law integrates its own evolution by
   * backward Euler: alpha(xi, x). Laws of several parts (Chaboche) and with scalars of their own (a stagnation surface)
   * keep them in their own fields of the history.
   */
  class BackStress
  {
  public:
    virtual ~BackStress() = default;

    /// Fields of its own, behind those of FlowHistory; @p start and @p end below point to them. They start at zero.
    virtual HistoryLayout history_layout() const = 0;

    /// false: there is no backstress at all.
    virtual bool acts() const
    {
      return true;
    }

    /// Are d alpha/d xi symmetric and d alpha/dx along the flow, so that the tangent stays symmetric?
    virtual bool symmetric() const
    {
      return false;
    }

    /// Why the law does not go together with a yield surface; empty: it does.
    virtual std::string objection(const YieldSurface &) const
    {
      return {};
    }

    virtual Mandel value(const double *history) const = 0;

    /// @p at is the yield surface at @p relative_stress (xi); writes the history at the end.
    virtual BackStressEnd update(const double *start,
                                 const Mandel &relative_stress,
                                 const YieldPoint &at,
                                 double flow,
                                 double *end) const = 0;
  };
} // namespace deltaform
