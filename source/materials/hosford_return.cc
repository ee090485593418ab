#include "hosford_return.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace deltaform
{
  namespace
  {
    constexpr double half_root = 0.70710678118654752440; // 1 / sqrt 2

    double whole_power(double base, int exponent)
    {
      double result = 1.;
      for (; exponent > 0; exponent /= 2, base *= base)
        if (exponent % 2 == 1)
          result *= base;
      return result;
    }
  } // namespace


  /// q(A, R) with its derivatives.
  struct HosfordReturn::Yield
  {
    double value, by_a, by_r, by_aa, by_ar, by_rr;
  };


  /// The trial stress in the plane, and what it would take to deform the metal elastically.
  struct HosfordReturn::Plane
  {
    double a, r; ///< A, R of the trial stress
    double cosine = 1., sine = 0.; ///< (B, T) = R (cosine, sine)
    double stiffness_a, stiffness_r;

    /// Of elastic strains [0], [1], [3] at third stress zero.
    Plane(const Elasticity &elastic, const double e1, const double e2, const double shear)
      : a(elastic.biaxial * half_root * (e1 + e2)), stiffness_a(elastic.biaxial), stiffness_r(2. * elastic.shear)
    {
      const double b = stiffness_r * half_root * (e1 - e2), t = stiffness_r * shear;
      r = std::hypot(b, t);
      if (r > 0.)
      {
        cosine = b / r;
        sine = t / r;
      }
    }
  };


  /// Where Newton's method is.
  struct HosfordReturn::Solution
  {
    double a, r, x;
    Yield at;
    FlowStress flow;
    double m_aa, m_ar, m_rr; ///< inverse of [1/stiffness] + x [d2q]
    double direction_a, direction_r; ///< that inverse times the gradient of q
    double resistance; ///< gradient . direction + H

    void linearize(const Plane &plane)
    {
      const double aa = 1. / plane.stiffness_a + x * at.by_aa, rr = 1. / plane.stiffness_r + x * at.by_rr,
                   ar = x * at.by_ar;
      const double inverse = 1. / (aa * rr - ar * ar);
      m_aa = rr * inverse;
      m_rr = aa * inverse;
      m_ar = -ar * inverse;
      direction_a = m_aa * at.by_a + m_ar * at.by_r;
      direction_r = m_ar * at.by_a + m_rr * at.by_r;
      resistance = at.by_a * direction_a + at.by_r * direction_r + flow.slope;
    }
  };


  HosfordReturn::HosfordReturn(const double exponent, const double r, std::unique_ptr<YieldSurface> surface)
    : exponent_(exponent), r_(r), whole_(exponent == std::floor(exponent) ? static_cast<int>(exponent) - 2 : 0),
      laws_{nullptr, std::move(surface)}, general_(laws_, ThirdDirection::stress_given, FlowHistory::size)
  {
  }


  HosfordReturn::Yield HosfordReturn::yield(const double a, const double r) const
  {
    const double s1 = half_root * (a + r), s2 = half_root * (a - r), s12 = 2. * half_root * r;
    const double largest = std::max({std::abs(s1), std::abs(s2), s12}), inverse = 1. / largest;
    const double z1 = s1 * inverse, z2 = s2 * inverse, z12 = s12 * inverse;
    const auto power = [&](const double z) {
      return whole_ > 0 ? whole_power(std::abs(z), whole_) : std::pow(std::abs(z), exponent_ - 2.);
    };
    double p1 = power(z1), p2 = power(z2), p12 = r_ * power(z12);
    const double sum = p1 * z1 * z1 + p2 * z2 * z2 + p12 * z12 * z12;
    const double q = std::pow(sum / (1. + r_), 1. / exponent_); // over the largest stress
    // |z/q|^(a-2)/(1+r): times z/q the gradient, times (a-1)/q the curvature
    const double scale = q * q / sum;
    p1 *= scale;
    p2 *= scale;
    p12 *= scale;
    const double g1 = (p1 * z1 + p12 * z12) / q, g2 = (p2 * z2 - p12 * z12) / q;
    const double curvature = (exponent_ - 1.) * inverse / q;
    Yield result;
    result.value = largest * q;
    result.by_a = half_root * (g1 + g2);
    result.by_r = half_root * (g1 - g2);
    result.by_aa = curvature * (.5 * (p1 + p2) - result.by_a * result.by_a);
    result.by_ar = curvature * (.5 * (p1 - p2) - result.by_a * result.by_r);
    result.by_rr = curvature * (.5 * (p1 + p2) + 2. * p12 - result.by_r * result.by_r);
    return result;
  }


  void HosfordReturn::begin(const Plane &plane, const FlowStress &at_rest, const double expected, Solution &now) const
  {
    // Hill's solution for the expected flow, brought to the yield surface: q is homogeneous
    const double hardening = at_rest.slope * expected;
    const double flow = at_rest.value + (hardening < at_rest.value ? hardening : 0.);
    const double mu = expected / (flow * (1. + r_));
    now.x = expected;
    now.a = plane.a / (1. + plane.stiffness_a * mu);
    now.r = plane.r / (1. + plane.stiffness_r * (1. + 2. * r_) * mu);
    now.at = yield(now.a, now.r);
    const double scale = flow / now.at.value;
    now.a *= scale;
    now.r *= scale;
    now.at.value = flow;
    now.at.by_aa /= scale;
    now.at.by_ar /= scale;
    now.at.by_rr /= scale;
  }


  bool HosfordReturn::solve(const FlowLaw &law, const Plane &plane, const double flowed, Solution &now) const
  {
    constexpr unsigned int most_iterations = 20;
    constexpr double close = 1e-9; // after one more step of second order: round-off
    const double size = std::abs(plane.a) + plane.r;
    double last = std::numeric_limits<double>::infinity();
    for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
    {
      if (iteration > 0)
        now.at = yield(now.a, now.r);
      now.flow = law.hardening.evaluate(flowed + now.x);
      now.linearize(plane);
      // The first two equations over their stiffness
      const double of_a = (now.a - plane.a) / plane.stiffness_a + now.x * now.at.by_a;
      const double of_r = (now.r - plane.r) / plane.stiffness_r + now.x * now.at.by_r;
      const double excess = now.at.value - now.flow.value;
      const double error = plane.stiffness_a * std::abs(of_a) + plane.stiffness_r * std::abs(of_r) + std::abs(excess);
      if (!(error < 4. * last))
        return false;
      last = error;
      const double dx = (excess - now.direction_a * of_a - now.direction_r * of_r) / now.resistance;
      now.a -= now.m_aa * of_a + now.m_ar * of_r + now.direction_a * dx;
      now.r -= now.m_ar * of_a + now.m_rr * of_r + now.direction_r * dx;
      now.x += dx;
      if (!(now.x > 0.) || !(now.r >= 0.))
        return false;
      if (error <= close * size)
        return true;
    }
    return false;
  }


  PointOutcome HosfordReturn::update(const FlowLaw &law, const PointUpdate &point) const
  {
    const double third_stress = point.third_stress;
    const double *const start = point.start;
    double *const trial = point.trial, *const tangent = point.tangent;
    Mandel &strain = point.strain, &stress = point.stress;
    const Elasticity &elastic = law.elastic;
    const double shift = third_stress * elastic.shift;
    const double e1 = strain[0] - start[0] - shift, e2 = strain[1] - start[1] - shift;
    const Plane plane(elastic, e1, e2, strain[3] - start[3]);
    const auto set_stress = [&](const double a, const double r) {
      const double b = plane.cosine * r;
      stress = {{half_root * (a + b) + third_stress, half_root * (a - b) + third_stress, third_stress,
                 plane.sine * r}};
      strain[2] = elastic.third_strain(stress) + trial[2];
    };

    const double size = std::abs(plane.a) + plane.r;
    if (!std::isfinite(size))
      return PointOutcome::not_finite;
    const double q = size > 0. ? yield(plane.a, plane.r).value : 0.;
    FlowStress at_rest{law.initial_flow_stress, 0.};
    if (q > at_rest.value)
      at_rest = law.hardening.evaluate(start[FlowHistory::equivalent]);
    const double excess = q - at_rest.value;
    // Twice, as in the general return map
    if (excess <= 2. * yield_round_off(law, start, q))
    {
      keep_history(start, trial);
      set_stress(plane.a, plane.r);
      if (tangent != nullptr)
        std::copy(elastic.condensed_tangent.begin(), elastic.condensed_tangent.end(), tangent);
      return PointOutcome::good;
    }

    const double guess = expected_increment(start, trial), least = 1e-3 * excess / (3. * elastic.shear);
    const double expected = guess > least && guess < q / elastic.shear ? guess : excess / (3. * elastic.shear);
    Solution now;
    begin(plane, at_rest, expected, now);
    if (!solve(law, plane, start[FlowHistory::equivalent], now))
      return general_.update(law, point);
    const double flow_a = half_root * (plane.a - now.a) / plane.stiffness_a;
    const double flow_r = (plane.r - now.r) / plane.stiffness_r, flow_b = half_root * flow_r * plane.cosine;
    trial[0] = start[0] + flow_a + flow_b;
    trial[1] = start[1] + flow_a - flow_b;
    trial[2] = -(trial[0] + trial[1]);
    trial[3] = start[3] + flow_r * plane.sine;
    trial[FlowHistory::equivalent] = start[FlowHistory::equivalent] + now.x;
    set_stress(now.a, now.r);
    if (tangent != nullptr)
      set_tangent(plane, now, tangent);
    return PointOutcome::good;
  }


  void HosfordReturn::set_tangent(const Plane &plane, const Solution &now, double *const tangent)
  {
    // Along A and R, and where the principal directions turn: R/R_trial, by its limit where R is small.
    const double inverse = 1. / now.resistance;
    const double aa = now.m_aa - inverse * now.direction_a * now.direction_a;
    const double ar = now.m_ar - inverse * now.direction_a * now.direction_r;
    const double rr = now.m_rr - inverse * now.direction_r * now.direction_r;
    const double small = 1. / (1. + plane.stiffness_r * now.x * now.at.by_rr);
    const double turn = plane.stiffness_r * (now.r > 1e-6 * std::abs(now.a) ? now.r / plane.r : small);
    const double c = plane.cosine, d = plane.sine;
    const double ab = ar * c, at = half_root * ar * d, bb = rr * c * c + turn * d * d;
    const double bt = half_root * (rr - turn) * c * d;
    tangent[0] = (aa + bb) / 2. + ab;
    tangent[1] = tangent[4] = (aa - bb) / 2.;
    tangent[5] = (aa + bb) / 2. - ab;
    tangent[3] = tangent[12] = at + bt;
    tangent[7] = tangent[13] = at - bt;
    tangent[15] = rr * d * d + turn * c * c;
    tangent[2] = tangent[6] = tangent[8] = tangent[9] = tangent[10] = tangent[11] = tangent[14] = 0.;
  }
} // namespace deltaform
