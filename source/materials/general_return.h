#pragma once

#include <deltaform/materials/plasticity.h>

namespace deltaform
{
  struct PlasticFlow;

  /**
   * Backward Euler for any yield surface, with backstress and rate factor if there are any. With mu = x/q, x the growth
   * of the equivalent plastic strain, and N = dq/dxi at the end,
   *
   *     C^-1 (xi + alpha(xi, x)) + mu q N = e - e_p,   x = mu q(xi),   q(xi) = s(e_n + x).
   *
   * For given mu the first equation is, without backstress, the minimum of a strictly convex function, which Newton's
   * method with step halving finds from everywhere; for quadratic surfaces (Mises, Hill 1948) it is linear. It leaves
   * one scalar equation in mu, which solve_consistency() solves whatever the slope of s. Where the third stress is
   * given, the third row reads xi_3 + alpha_3 = t_3.
   * Newton's method for xi and x at once, tried first, nearly always gets there in a few evaluations of the surface.
   * J.C. Simo, T.J.R. Hughes, Computational Inelasticity, Springer 1998, sec. 3.6; step control: W.M. Scherzinger, A
   * return mapping algorithm for isotropic and anisotropic plasticity models using a line search method, Comput.
   * Methods Appl. Mech. Eng. 317 (2017) 526.
   */
  class GeneralReturn final : public ReturnMap
  {
  public:
    /// @p laws outlive this; @p n_history values of a point.
    GeneralReturn(const FlowLaws &laws, ThirdDirection third, unsigned int n_history);

    PointOutcome update(const FlowLaw &law, const PointUpdate &point) const override;

  private:
    struct State;
    struct Linearized;

    void set_elastic(const FlowLaw &law, const PointUpdate &point, State &state) const;
    /// The laws and the first equation at the present xi after the growth @p x.
    void set_residual(const FlowLaw &law, State &state, double x) const;
    void set_jacobian(const FlowLaw &law, State &state, double mu) const;
    /// All equations at once. @return false: not found soon
    bool find_at_once(const FlowLaw &law, State &state, FlowStress &flow, double guess) const;
    /// The multiplier by the scalar equation, the stress for each by find_stress(): from everywhere.
    PlasticFlow find_nested(const FlowLaw &law, State &state, FlowStress &flow, double guess) const;
    bool find_stress(const FlowLaw &law, State &state, double mu) const;
    double largest_multiplier(const FlowLaw &law, const State &state) const;
    PointOutcome stay_elastic(const FlowLaw &law, const PointUpdate &point, State &state) const;
    /// Strains and stress at the end of the flow that @p state solves.
    void set_flow(const FlowLaw &law, const PointUpdate &point, const State &state) const;
    Linearized linearize(const FlowLaw &law, const State &state, const FlowStress &flow) const;
    void set_tangent(const FlowLaw &law, const State &state, const FlowStress &flow, double *tangent) const;

    const FlowLaws &laws_;
    bool third_stress_given_;
    unsigned int n_history_;
    unsigned int back_stress_first_, rate_first_; ///< where the laws' own values of history begin
  };
} // namespace deltaform
