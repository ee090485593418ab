#pragma once

#include <deltaform/materials/hardening.h>
#include <deltaform/materials/yield_surface.h>

#include <array>
#include <string>
#include <vector>

namespace deltaform
{
  /// The backstress at the end of an increment, with its derivatives.
  struct BackStressEnd
  {
    Mandel value; ///< backstress alpha (Kirchhoff stress)
    std::array<double, 16> by_relative_stress; ///< d alpha/d xi at fixed x, 4 x 4, row-major (1)
    Mandel by_flow; ///< d alpha/dx at fixed xi (stress)
  };


  /// Armstrong and Frederick's: d alpha = (C/q) dev(xi) dx - gamma alpha dx.
  struct BackStressTerm
  {
    double C; ///< initial modulus in tension (stress)
    double gamma; ///< rate (1) at which it saturates, at C/gamma
  };


  /// The direction dev(xi)/q in which a backstress follows the relative stress xi (Ziegler), with its derivative.
  struct Direction
  {
    Mandel value; ///< 1
    std::array<double, 16> by_relative_stress; ///< 4 x 4, row-major (1/stress)

    Direction(const Mandel &xi, const YieldPoint &at)
    {
      const double mean = (xi[0] + xi[1] + xi[2]) / 3., inverse = 1. / at.value;
      for (unsigned int i = 0; i < 4; ++i)
        value[i] = (xi[i] - (i < 3 ? mean : 0.)) * inverse;
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          by_relative_stress[4 * i + j] =
            ((i == j ? 1. : 0.) - (i < 3 && j < 3 ? 1. / 3. : 0.) - value[i] * at.gradient[j]) * inverse;
    }
  };


  /// What a backstress goes from: its own fields of the history.
  struct BackStressStart
  {
    const double *values; ///< of which backward Euler makes the end: h* of BDF2 (Bdf2Predictor), or the committed ones
    const double *committed; ///< at the begin of the increment
    double predicted_flow; ///< growth of the equivalent plastic strain from there to values (1); 0: they are the same
  };


  /**
   * Kinematic hardening: q(stress - alpha) = flow stress, with alpha a function of history. With xi = stress - alpha at
   * the end of the increment and x the growth of the equivalent plastic strain, the law integrates its own evolution by
   * backward Euler: alpha(xi, x). What does not go on smoothly may be integrated by a one-step rule from the committed
   * values instead, over the whole growth, x + predicted_flow. Laws of several parts (Chaboche) and with scalars of
   * their own (a stagnation surface) keep them in their own fields of the history.
   */
  class BackStress
  {
  public:
    virtual ~BackStress() = default;

    /// Fields of its own, behind those of FlowHistory, to which the pointers below point. They start at zero.
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

    /// Of a law that is a sum of such terms and keeps each as a tensor in its history; null: it is not. At most 8.
    virtual const std::vector<BackStressTerm> *terms() const
    {
      return nullptr;
    }

    /// Why the law does not go together with a yield surface and a flow curve; empty: it does.
    virtual std::string objection(const YieldSurface &, const Hardening &) const
    {
      return {};
    }

    virtual Mandel value(const double *history) const = 0;

    /// @p at is the yield surface at @p relative_stress (xi); writes the history at the end.
    virtual BackStressEnd update(const BackStressStart &start,
                                 const Mandel &relative_stress,
                                 const YieldPoint &at,
                                 double flow,
                                 double *end) const = 0;
  };
} // namespace deltaform
