#pragma once

#include "general_return.h"

namespace deltaform
{
  /**
   * Logan and Hosford in a sheet, in-plane strains and third stress given. What flows is isotropic in the plane, so
   * that stress and trial stress have the same principal directions: with
   *
   *     A = (t1 + t2 - 2 t3)/sqrt 2,   R = |(t1 - t2, 2 t12)|/sqrt 2,
   *
   * three equations are left of backward Euler for A, R and x, the growth of the equivalent plastic strain,
   *
   *     A + E/(1 - nu) x dq/dA = A_trial,   R + 2 G x dq/dR = R_trial,   q(A, R) = s(e_n + x),
   *
   * solved at once by Newton's method from Hill's solution for the x that is expected. Where that does not converge
   * quickly, the general return map finds what it has not.
   */
  class HosfordReturn final : public ReturnMap
  {
  public:
    /// @p surface is the one of this exponent and r, for the general return map.
    HosfordReturn(double exponent, double r, std::unique_ptr<YieldSurface> surface);

    PointOutcome update(const FlowLaw &law, const PointUpdate &point) const override;

  private:
    struct Yield;
    struct Plane;
    struct Solution;

    Yield yield(double a, double r) const;
    /// Newton's method starts from here: @p expected is the growth of the equivalent plastic strain.
    void begin(const Plane &plane, const FlowStress &at_rest, double expected, Solution &now) const;
    bool solve(const FlowLaw &law, const Plane &plane, double flowed, Solution &now) const;
    static void set_tangent(const Plane &plane, const Solution &now, double *tangent);

    double exponent_, r_;
    int whole_; ///< the exponent less two, if it is whole; else 0
    FlowLaws laws_;
    GeneralReturn general_;
  };
} // namespace deltaform
