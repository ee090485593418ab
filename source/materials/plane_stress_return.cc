#include "closed_returns.h"
#include "consistency.h"

#include <algorithm>

namespace deltaform
{
  /*
   * The stress (t1, t2, t3, t12) with t3 given has the deviator of (t1 - t3, t2 - t3, 0, t12), a state of plane stress
   * whose elastic in-plane strains are those of the former less t3 (1 - 2 nu) / E. In its components along the common
   * eigenvectors of the plane-stress elasticity and of the projection on the deviator,
   *
   *     A = (t1 + t2 - 2 t3) / sqrt 2,   B = (t1 - t2) / sqrt 2,   T = sqrt 2 t12,   q^2 = A^2/2 + 3/2 (B^2 + T^2),
   *
   * backward Euler with the multiplier l = (3/2) x / q, x the increment of the equivalent plastic strain, gives
   *
   *     A = A_trial / (1 + a l),   (B, T) = (B, T)_trial / (1 + b l),   a = E / (3 (1 - nu)),   b = 2 G,
   *     flow(e_n + 2/3 l q(l)) = q(l),   d e_p = l (A/3, B, T),
   *
   * with l the one unknown. It is solved as 1 - flow / q = 0, which for a = b and a constant flow stress is linear.
   * Normal anisotropy r (Hill 1948) has the same eigenvectors, with other eigenvalues:
   *
   *     q^2 = (A^2 + (1 + 2 r) (B^2 + T^2)) / (1 + r),
   *     a = (2/3) E / ((1 + r) (1 - nu)),   b = (4/3) G (1 + 2 r) / (1 + r),
   *     d e_p = (2/3) l (A, (1 + 2 r) B, (1 + 2 r) T) / (1 + r).
   *
   * J.C. Simo, R.L. Taylor, A return mapping algorithm for plane stress elastoplasticity, Int. J. Numer. Meth. Eng.
   * 22 (1986) 649; J.C. Simo, T.J.R. Hughes, Computational Inelasticity, Springer 1998, box 3.3.
   */
  namespace
  {
    constexpr double half_root = 0.70710678118654752440; // 1 / sqrt 2

    /// The parts of q^2 and of the flow: Mises, known to the compiler.
    struct MisesParts
    {
      static double square_a(const double a_square)
      {
        return a_square / 2.;
      }
      static double square_b(const double b_square)
      {
        return 1.5 * b_square;
      }
      static double flow_a(const double a)
      {
        return a / 3.;
      }
      static double flow_b(const double b)
      {
        return b;
      }
    };

    /// The same of Hill 1948 with normal anisotropy r.
    struct NormalAnisotropyParts
    {
      double weight_a, weight_b;

      explicit NormalAnisotropyParts(const double r)
        : weight_a(1. / (1. + r)), weight_b((1. + 2. * r) / (1. + r))
      {
      }
      double square_a(const double a_square) const
      {
        return weight_a * a_square;
      }
      double square_b(const double b_square) const
      {
        return weight_b * b_square;
      }
      double flow_a(const double a) const
      {
        return 2. / 3. * weight_a * a;
      }
      double flow_b(const double b) const
      {
        return 2. / 3. * weight_b * b;
      }
    };

    /// q(l) and what else depends on the multiplier alone.
    struct Returned
    {
      double scale_a, scale_b; ///< 1 / (1 + a l), 1 / (1 + b l)
      double q, inverse_q, slope; ///< q, 1/q, (dq/dl)/q
      double x, x_slope; ///< 2/3 l q, its derivative
    };

    struct TrialStress
    {
      double a_square, b_square; ///< parts of q^2 of the trial stress, of A and of (B, T)
      double a, b;

      Returned at(const double l) const
      {
        Returned r;
        const double both = 1. / ((1. + a * l) * (1. + b * l));
        r.scale_a = (1. + b * l) * both;
        r.scale_b = (1. + a * l) * both;
        const double a_q = a_square * r.scale_a * r.scale_a;
        const double b_q = b_square * r.scale_b * r.scale_b;
        const double q_square = a_q + b_q, inverse = 1. / q_square;
        r.q = std::sqrt(q_square);
        r.inverse_q = r.q * inverse; // side by side with the root, not after it
        r.slope = -(a * r.scale_a * a_q + b * r.scale_b * b_q) * inverse;
        r.x = 2. / 3. * l * r.q;
        r.x_slope = 2. / 3. * r.q * (1. + l * r.slope);
        return r;
      }

      /// The multiplier at which the equivalent plastic strain grows by about @p x; not positive if there is none.
      double multiplier(const double x) const
      {
        if (!(x > 0.))
          return 0.;
        // q = q_trial / (1 + c l) with the mean c of a and b, then one step of Newton
        const double q_square = a_square + b_square;
        const double c = (a * a_square + b * b_square) / q_square;
        double l = x / (2. / 3. * std::sqrt(q_square) - c * x);
        if (l > 0.)
        {
          const Returned r = at(l);
          l -= (r.x - x) / r.x_slope;
        }
        return l;
      }
    };


    /// Elastic trial stress less t3 in its components, and what is made of it.
    struct PlaneStress
    {
      const Elasticity &elastic;
      const PointUpdate &point;
      double A, B, T;

      PlaneStress(const Elasticity &law, const PointUpdate &at)
        : elastic(law), point(at)
      {
        const double shift = point.third_stress * elastic.shift;
        const double e1 = point.strain[0] - point.start[0] - shift;
        const double e2 = point.strain[1] - point.start[1] - shift;
        A = elastic.biaxial * half_root * (e1 + e2);
        B = 2. * elastic.shear * half_root * (e1 - e2);
        T = 2. * elastic.shear * (point.strain[3] - point.start[3]);
      }

      /// Stress and strain through the thickness, the plastic strain at the end being known.
      void set_stress(const double at_a, const double at_b) const
      {
        const double third_stress = point.third_stress;
        point.stress = {{half_root * (at_a * A + at_b * B) + third_stress,
                         half_root * (at_a * A - at_b * B) + third_stress,
                         third_stress,
                         at_b * T}};
        point.strain[2] = elastic.third_strain(point.stress) + point.trial[2];
      }

      PointOutcome stay_elastic() const
      {
        keep_history(point.start, point.trial);
        set_stress(1., 1.);
        if (point.tangent != nullptr)
          std::copy(elastic.condensed_tangent.begin(), elastic.condensed_tangent.end(), point.tangent);
        return PointOutcome::good;
      }

      /// Plastic strain and stress after the flow @p r by the multiplier @p l.
      template <typename Parts>
      void set_flow(const Parts &parts, const Returned &r, const double l) const
      {
        const double *const start = point.start;
        double *const end = point.trial;
        const double flow_a = parts.flow_a(half_root * l * (r.scale_a * A));
        const double flow_b = parts.flow_b(half_root * l * (r.scale_b * B));
        end[0] = start[0] + flow_a + flow_b;
        end[1] = start[1] + flow_a - flow_b;
        end[2] = -(end[0] + end[1]);
        end[3] = start[3] + parts.flow_b(l * (r.scale_b * T));
        end[FlowHistory::equivalent] = start[FlowHistory::equivalent] + r.x;
        set_stress(r.scale_a, r.scale_b);
      }

      /// Xi = (C^-1 + l P)^-1 and m = Xi P t in the components (A, B, T):
      /// d t = (Xi - m x m / (P t . m + (4/9) q^2 / (1/H - 2/3 l))) d e. Infinite terms, from H = 0 or H infinite, do
      /// what they should.
      template <typename Parts>
      void set_tangent(const Parts &parts, const Returned &r, const double l, const double H) const
      {
        double *const tangent = point.tangent;
        const double a_now = r.scale_a * A, b_now = r.scale_b * B, t_now = r.scale_b * T;
        const double xi_a = elastic.biaxial * r.scale_a, xi_b = 2. * elastic.shear * r.scale_b;
        const double m_a = parts.flow_a(xi_a * a_now);
        const double m_b = parts.flow_b(xi_b * b_now), m_t = parts.flow_b(xi_b * t_now);
        const double inverse = 1. / (parts.flow_a(m_a * a_now) + parts.flow_b(m_b * b_now) + parts.flow_b(m_t * t_now) +
                                     4. / 9. * r.q * r.q / (1. / H - 2. / 3. * l));
        const double aa = xi_a - inverse * m_a * m_a, bb = xi_b - inverse * m_b * m_b, ab = -inverse * m_a * m_b;
        const double at = -inverse * m_a * m_t * half_root, bt = -inverse * m_b * m_t * half_root;
        tangent[0] = (aa + bb) / 2. + ab;
        tangent[1] = tangent[4] = (aa - bb) / 2.;
        tangent[5] = (aa + bb) / 2. - ab;
        tangent[3] = tangent[12] = at + bt;
        tangent[7] = tangent[13] = at - bt;
        tangent[15] = xi_b - inverse * m_t * m_t;
        tangent[2] = tangent[6] = tangent[8] = tangent[9] = tangent[10] = tangent[11] = tangent[14] = 0.;
      }
    };


    template <typename Parts>
    PointOutcome quadratic_return(const Parts &parts, const FlowLaw &law, const PointUpdate &point)
    {
      const Elasticity &elastic = law.elastic;
      const PlaneStress plane(elastic, point);
      const TrialStress stress_at{parts.square_a(plane.A * plane.A),
                                  parts.square_b(plane.B * plane.B + plane.T * plane.T),
                                  parts.flow_a(elastic.biaxial),
                                  parts.flow_b(2. * elastic.shear)};
      const double q_square = stress_at.a_square + stress_at.b_square;
      if (q_square <= law.initial_flow_stress * law.initial_flow_stress)
        return plane.stay_elastic();
      if (!std::isfinite(q_square))
        return PointOutcome::not_finite;

      FlowStress flow{};
      Returned r{};
      const double flowed = point.start[FlowHistory::equivalent];
      const auto excess = [&](const double l) -> Excess {
        r = stress_at.at(l);
        flow = law.hardening.evaluate(flowed + r.x);
        return {1. - flow.value * r.inverse_q, (flow.value * r.slope - flow.slope * r.x_slope) * r.inverse_q};
      };
      // q <= q_trial / (1 + a l), or with b if that is less, and the flow stress does not fall under its initial value.
      const double q_trial = std::sqrt(q_square), ratio = q_trial / law.initial_flow_stress;
      const double upper = ratio / std::min(stress_at.a, stress_at.b);
      const double start = std::fmin(ratio - 1., 1.) / stress_at.b;
      const double guess = stress_at.multiplier(expected_increment(point.start, point.trial));
      const PlasticFlow solved = solve_consistency(excess, guess, start, upper);
      if (!solved.found)
        return PointOutcome::not_converged;
      const double l = solved.amount;
      if (l == 0. || rests_on_surface(law, point.start, q_trial, q_trial - r.q))
        return plane.stay_elastic();
      plane.set_flow(parts, r, l);
      if (point.tangent != nullptr)
        plane.set_tangent(parts, r, l, flow.slope);
      return PointOutcome::good;
    }
  } // namespace


  PointOutcome PlaneStressReturn::update(const FlowLaw &law, const PointUpdate &point) const
  {
    return quadratic_return(MisesParts(), law, point);
  }


  PointOutcome NormalAnisotropyReturn::update(const FlowLaw &law, const PointUpdate &point) const
  {
    return quadratic_return(NormalAnisotropyParts(r_), law, point);
  }
} // namespace deltaform
