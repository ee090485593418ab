#pragma once

#include <deltaform/materials/plasticity.h>

#include <Eigen/Core>

namespace deltaform
{
  /**
   * Backward Euler for a yield surface that is a quadratic form, q^2 = t . P t (Mises, Hill 1948), with a rate factor
   * and with a backstress of Armstrong and Frederick's terms, if there are any. In the eigenvectors that P and the
   * elasticity have in common everything is component by component: with c = 1/compliance and the weights w_k,
   * q^2 = sum w_k y_k^2,
   *
   *     xi_k = s n_k,   n_k = Z_k/D_k,   Z_k = y_trial,k - sum_i alpha_i,k/(1 + gamma_i x),
   *     D_k = s + c w_k x + sum_i C_i x/(1 + gamma_i x),
   *
   * and the yield condition is one equation in the growth x of the equivalent plastic strain,
   *
   *     1 - 1/h = 0,   h^2 = sum w_k n_k^2,   s = s(e_n + x, x/duration, ...).
   *
   * What flows is x w_k n_k, the backstress ends at alpha_i = (alpha_i,n + C_i x n)/(1 + gamma_i x). For Mises as in
   * J.C. Simo, T.J.R. Hughes, Computational Inelasticity, Springer 1998, sec. 3.3 and 3.4; with terms that saturate:
   * S. Hartmann, P. Haupt, Stress computation and consistent tangent operator using non-linear kinematic hardening
   * models, Int. J. Numer. Meth. Eng. 36 (1993) 3801.
   */
  class QuadraticReturn final : public ReturnMap
  {
  public:
    /// Can it do this? The yield surface has a quadratic form, and the backstress, if there is one, such terms.
    static bool serves(const FlowLaws &laws);

    /// @p laws outlive this; @p poisson that of the elasticity; @p n_history values of a point.
    QuadraticReturn(const FlowLaws &laws, ThirdDirection third, double poisson, unsigned int n_history);

    PointOutcome update(const FlowLaw &law, const PointUpdate &point) const override;

  private:
    using Vector3 = Eigen::Vector3d;
    using Matrix3 = Eigen::Matrix3d;
    using Matrix43 = Eigen::Matrix<double, 4, 3>;

    static constexpr unsigned int most_terms = 8;

    struct Trial;
    struct Flow;

    Trial trial_of(const FlowLaw &law, const PointUpdate &point) const;
    void set_flow(const Trial &trial, double x, Flow &flow) const;
    PointOutcome stay_elastic(const FlowLaw &law, const PointUpdate &point, const Trial &trial) const;
    void set_stress(const FlowLaw &law, const PointUpdate &point, const Trial &trial, const Vector3 &y) const;
    void set_end(const FlowLaw &law, const PointUpdate &point, const Trial &trial, const Flow &flow) const;
    void set_tangent(const FlowLaw &law, const Trial &trial, const Flow &flow, double *tangent) const;

    const FlowLaws &laws_;
    const std::vector<BackStressTerm> *terms_; ///< null: no backstress
    bool third_stress_given_;
    unsigned int n_history_, rate_first_;
    double relative_stiffness_; ///< c over Young's modulus
    Vector3 weight_; ///< w_k
    Matrix43 stress_; ///< of unit components, less the third one where it is given
    Matrix43 components_; ///< of unit stresses
    Matrix43 flow_; ///< plastic strain of unit n_k
    Matrix43 deviator_; ///< of unit components
  };
} // namespace deltaform
