#include "consistency.h"
#include "return_map.h"

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
  PointOutcome radial_return(const J2 &j2,
                             const Mandel &strain,
                             const double *committed,
                             double *trial,
                             Mandel &stress,
                             double *tangent)
  {
    const Elasticity &elastic = j2.elastic;
    const double G            = elastic.shear;

    Mandel s; // trial deviator
    for (unsigned int i = 0; i < 4; ++i)
      s[i] = strain[i] - committed[i];
    const double trace = s[0] + s[1] + s[2];
    for (unsigned int i = 0; i < 3; ++i)
      s[i] = 2. * G * (s[i] - trace / 3.);
    s[3] *= 2. * G;
    const double pressure = elastic.bulk * trace;
    const double q_square = 1.5 * (s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + s[3] * s[3]);

    const auto stay_elastic = [&]()
    {
      keep_history(committed, trial);
      stress = {{s[0] + pressure, s[1] + pressure, s[2] + pressure, s[3]}};
      if (tangent != nullptr)
        elastic.tangent(tangent);
      return PointOutcome::good;
    };
    if (q_square <= j2.initial_flow_stress * j2.initial_flow_stress)
      return stay_elastic();
    if (!std::isfinite(q_square))
      return PointOutcome::not_finite;

    const double q = std::sqrt(q_square);
    FlowStress flow{};
    const auto excess = [&](const double x) -> Excess
    {
      flow = j2.hardening.evaluate(committed[4] + x);
      return {1. - (3. * G * x + flow.value) / q, -(3. * G + flow.slope) / q};
    };
    const double upper       = (q - j2.initial_flow_stress) / (3. * G);
    const PlasticFlow solved = solve_consistency(excess, expected_increment(committed, trial), upper, upper);
    if (!solved.found)
      return PointOutcome::not_converged;
    const double x = solved.amount;
    if (x == 0.)
      return stay_elastic();

    // The flow stress has the digits that q - 3 G x loses after a large increment.
    const double remaining = solved.resolved ? flow.value / q : 1. - 3. * G * x / q;
    const double flow_of_s = 1.5 * x / q;
    for (unsigned int i = 0; i < 4; ++i)
    {
      trial[i]  = committed[i] + flow_of_s * s[i];
      stress[i] = remaining * s[i] + (i < 3 ? pressure : 0.);
    }
    trial[4] = committed[4] + x;

    if (tangent != nullptr)
    {
      const double deviatoric = 2. * G * remaining;
      const double common     = elastic.bulk - deviatoric / 3.;
      // n x n = (3/2) s x s / q^2
      const double radial = 9. * G * G * (x / q - 1. / (3. * G + flow.slope)) / q_square;
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          tangent[4 * i + j] = radial * s[i] * s[j] + (i < 3 && j < 3 ? common : 0.) + (i == j ? deviatoric : 0.);
    }
    return PointOutcome::good;
  }
} // namespace deltaform
