#include "closed_returns.h"
#include "consistency.h"

#include <algorithm>

namespace deltaform
{
  /*
   * With the elastic trial deviator s = 2 G dev(e - e_p), q = sqrt(3/2) |s|, and x the increment of the equivalent
   * plastic strain, backward Euler gives
   *
   *     q - 3 G x = flow(e_n + x),   d e_p = x (3/2) s / q,   stress = K tr(e) 1 + (1 - 3 G x / q) s,
   *     d stress / d strain = K 1x1 + 2 G (1 - 3 G x / q) I_dev + 6 G^2 (x / q - 1 / (3 G + H)) n x n,   n = s / |s|,
   *
   * H the slope of the flow stress at e_n + x. First order in the increment; exact if the direction of s does not
   * change. J.C. Simo, T.J.R. Hughes, Computational Inelasticity, Springer 1998, boxes 3.1 and 3.2.
   */
  namespace
  {
    /// @p remaining 1 - 3 G x/q
    void set_tangent(const Elasticity &elastic,
                     const Mandel &s,
                     const double inverse_q,
                     const double remaining,
                     const double x,
                     const double slope,
                     double *tangent)
    {
      const double G = elastic.shear;
      const double deviatoric = 2. * G * remaining;
      const double common = elastic.bulk - deviatoric / 3.;
      // n x n = (3/2) s x s / q^2
      const double radial = 9. * G * G * inverse_q * inverse_q * (x * inverse_q - 1. / (3. * G + slope));
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          tangent[4 * i + j] = radial * s[i] * s[j] + (i < 3 && j < 3 ? common : 0.) + (i == j ? deviatoric : 0.);
    }
  } // namespace


  PointOutcome RadialReturn::update(const FlowLaw &law, const PointUpdate &point) const
  {
    const Mandel &strain = point.strain;
    const double *const committed = point.start;
    double *const trial = point.trial, *const tangent = point.tangent;
    Mandel &stress = point.stress;
    const Elasticity &elastic = law.elastic;
    const double G = elastic.shear;

    // Trial deviator
    const double e0 = strain[0] - committed[0], e1 = strain[1] - committed[1], e2 = strain[2] - committed[2];
    const double trace = e0 + e1 + e2, mean = trace / 3., pressure = elastic.bulk * trace;
    const double s0 = 2. * G * (e0 - mean), s1 = 2. * G * (e1 - mean), s2 = 2. * G * (e2 - mean);
    const double s3 = 2. * G * (strain[3] - committed[3]);
    const double q_square = 1.5 * (s0 * s0 + s1 * s1 + s2 * s2 + s3 * s3);

    const auto stay_elastic = [&]() {
      keep_history(committed, trial);
      stress = {{s0 + pressure, s1 + pressure, s2 + pressure, s3}};
      if (tangent != nullptr)
        std::copy(elastic.tangent.begin(), elastic.tangent.end(), tangent);
      return PointOutcome::good;
    };
    if (q_square <= law.initial_flow_stress * law.initial_flow_stress)
      return stay_elastic();
    if (!std::isfinite(q_square))
      return PointOutcome::not_finite;

    const double q = std::sqrt(q_square);
    const double inverse_q = 1. / q;
    FlowStress flow{};
    const auto excess = [&](const double x) -> Excess {
      flow = law.hardening.evaluate(committed[FlowHistory::equivalent] + x);
      return {1. - (3. * G * x + flow.value) * inverse_q, -(3. * G + flow.slope) * inverse_q};
    };
    const double start = (q - law.initial_flow_stress) / (3. * G);
    const PlasticFlow solved = solve_consistency(excess, expected_increment(committed, trial), start, q / (3. * G));
    if (!solved.found)
      return PointOutcome::not_converged;
    const double x = solved.amount;
    if (x == 0. || rests_on_surface(law, committed, q, 3. * G * x))
      return stay_elastic();

    // The flow stress has the digits that q - 3 G x loses after a large increment.
    const double remaining = solved.resolved ? flow.value * inverse_q : 1. - 3. * G * x * inverse_q;
    const Mandel s{{s0, s1, s2, s3}};
    const double flow_of_s = 1.5 * x * inverse_q;
    for (unsigned int i = 0; i < 4; ++i)
    {
      trial[i] = committed[i] + flow_of_s * s[i];
      stress[i] = remaining * s[i] + (i < 3 ? pressure : 0.);
    }
    trial[FlowHistory::equivalent] = committed[FlowHistory::equivalent] + x;

    if (tangent != nullptr)
      set_tangent(elastic, s, inverse_q, remaining, x, flow.slope, tangent);
    return PointOutcome::good;
  }
} // namespace deltaform
