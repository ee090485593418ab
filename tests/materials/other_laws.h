#pragma once
// Laws that the program does not have: what the interfaces of the materials have to carry.
#include <deltaform/materials/plasticity.h>

#include <cmath>
#include <vector>

namespace deltaform
{
  namespace testing
  {
    /// A surface without its closed forms: the general return map serves it.
    class WithoutClosedForm : public YieldSurface
    {
    public:
      explicit WithoutClosedForm(std::unique_ptr<YieldSurface> surface)
        : surface_(std::move(surface))
      {
      }

      YieldPoint evaluate(const Mandel &stress) const override
      {
        return surface_->evaluate(stress);
      }

      double equivalent_stress(const Mandel &stress) const override
      {
        return surface_->equivalent_stress(stress);
      }

      Symmetry symmetry() const override
      {
        return surface_->symmetry();
      }

    private:
      std::unique_ptr<YieldSurface> surface_;
    };


    /**
     * Hill 1948, q^2 = t . P t, with the anisotropy of directions 1 and 2 in the plane, r0 and r90 (the same: normal
     * anisotropy r): with G = 1/(1+r0), H = r0/(1+r0), F = r0/(r90 (1+r0)), N from r45,
     *
     *     q^2 = F (t2-t3)^2 + G (t3-t1)^2 + H (t1-t2)^2 + 2 N t12^2,   N = (F + G) (r45 + 1/2).
     *
     * R. Hill, A theory of the yielding and plastic flow of anisotropic metals, Proc. R. Soc. A 193 (1948) 281.
     */
    class Hill48 : public YieldSurface
    {
    public:
      Hill48(const double r0, const double r45, const double r90)
        : symmetry_(r0 == r90 && r0 == r45 ? Symmetry::about_third_axis : Symmetry::orthotropic)
      {
        const double G = 1. / (1. + r0), H = r0 / (1. + r0), F = r0 / (r90 * (1. + r0));
        P_ = {{G + H, -H, -G, 0., -H, F + H, -F, 0., -G, -F, F + G, 0., 0., 0., 0., (F + G) * (r45 + .5)}};
      }

      double equivalent_stress(const Mandel &t) const override
      {
        const Mandel Pt = product(t);
        return std::sqrt(t[0] * Pt[0] + t[1] * Pt[1] + t[2] * Pt[2] + t[3] * Pt[3]);
      }

      YieldPoint evaluate(const Mandel &t) const override
      {
        YieldPoint at;
        at.value = equivalent_stress(t);
        at.gradient = product(t);
        for (auto &component : at.gradient)
          component /= at.value;
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int j = 0; j < 4; ++j)
            at.hessian[4 * i + j] = (P_[4 * i + j] - at.gradient[i] * at.gradient[j]) / at.value;
        return at;
      }

      Symmetry symmetry() const override
      {
        return symmetry_;
      }

    private:
      Mandel product(const Mandel &t) const
      {
        // by differences, so that a pressure changes nothing
        const Mandel s{{t[0] - t[2], t[1] - t[2], 0., t[3]}};
        Mandel result{};
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int j = 0; j < 4; ++j)
            result[i] += P_[4 * i + j] * s[j];
        return result;
      }

      Symmetry symmetry_;
      std::array<double, 16> P_;
    };


    /// q^4 = (q_a^4 + q_b^4)/2 of two other surfaces: smooth, convex and not quadratic.
    class Quartic : public YieldSurface
    {
    public:
      Quartic(std::unique_ptr<YieldSurface> a, std::unique_ptr<YieldSurface> b)
        : a_(std::move(a)), b_(std::move(b))
      {
      }

      double equivalent_stress(const Mandel &t) const override
      {
        const double a = a_->equivalent_stress(t), b = b_->equivalent_stress(t);
        return std::sqrt(std::sqrt((a * a * a * a + b * b * b * b) / 2.));
      }

      YieldPoint evaluate(const Mandel &t) const override
      {
        YieldPoint at{equivalent_stress(t), {}, {}};
        const double cube = at.value * at.value * at.value;
        const std::array<YieldPoint, 2> parts = {{a_->evaluate(t), b_->evaluate(t)}};
        for (const YieldPoint &part : parts)
          for (unsigned int i = 0; i < 4; ++i)
            at.gradient[i] += .5 * std::pow(part.value, 3) / cube * part.gradient[i];
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int j = 0; j < 4; ++j)
          {
            double &h = at.hessian[4 * i + j];
            h = -3. / at.value * at.gradient[i] * at.gradient[j];
            for (const YieldPoint &part : parts)
              h += .5 *
                   (3. * std::pow(part.value, 2) * part.gradient[i] * part.gradient[j] +
                    std::pow(part.value, 3) * part.hessian[4 * i + j]) /
                   cube;
          }
        return at;
      }

    private:
      std::unique_ptr<YieldSurface> a_, b_;
    };


    /// A surface that is defined for plane stress only.
    class PlaneStressOnly : public WithoutClosedForm
    {
    public:
      using WithoutClosedForm::WithoutClosedForm;

      bool serves(const ThirdDirection third) const override
      {
        return third == ThirdDirection::stress_given;
      }
    };


    /**
     * Armstrong and Frederick in Ziegler's form, several of them (Chaboche): d alpha_i = (C_i/q) xi dx - gamma_i
     * alpha_i dx, by backward Euler alpha_i = (alpha_i,n + C_i x/q xi)/(1 + gamma_i x). J.L. Chaboche, Int. J.
     * Plasticity 2 (1986) 149.
     */
    class Chaboche : public BackStress
    {
    public:
      struct Part
      {
        double C, gamma;
      };

      explicit Chaboche(std::vector<Part> parts)
        : parts_(std::move(parts))
      {
      }

      HistoryLayout history_layout() const override
      {
        HistoryLayout layout;
        for (unsigned int i = 0; i < parts_.size(); ++i)
          layout.append({{"backstress_" + std::to_string(i + 1), HistoryKind::tensor, "stress"}});
        return layout;
      }

      std::string objection(const YieldSurface &surface, const Hardening &) const override
      {
        return surface.serves(ThirdDirection::strain_given) ? "" : "not with a surface for plane stress.";
      }

      Mandel value(const double *history) const override
      {
        Mandel sum{};
        for (unsigned int i = 0; i < 4 * parts_.size(); ++i)
          sum[i % 4] += history[i];
        return sum;
      }

      BackStressEnd update(const BackStressStart &from,
                           const Mandel &xi,
                           const YieldPoint &at,
                           const double x,
                           double *end) const override
      {
        const double *start = from.values;
        BackStressEnd result{};
        const double q = at.value;
        for (unsigned int part = 0; part < parts_.size(); ++part)
        {
          const auto [C, gamma] = parts_[part];
          const double scale = 1. / (1. + gamma * x);
          for (unsigned int i = 0; i < 4; ++i)
          {
            const double alpha = scale * (start[4 * part + i] + C * x / q * xi[i]);
            end[4 * part + i] = alpha;
            result.value[i] += alpha;
            result.by_flow[i] += scale * (C / q * xi[i] - gamma * alpha);
            result.by_relative_stress[5 * i] += scale * C * x / q;
            for (unsigned int j = 0; j < 4; ++j)
              result.by_relative_stress[4 * i + j] -= scale * C * x / (q * q) * xi[i] * at.gradient[j];
          }
        }
        return result;
      }

    private:
      std::vector<Part> parts_;
    };


    /**
     * Cowper and Symonds with heat: s (1 + (rate/D)^(1/p)) (1 - c T), where the flow itself heats the metal, dT = b s
     * dx: a factor that needs the duration and a scalar of its own.
     */
    class CowperSymondsWithHeat : public RateFactor
    {
    public:
      CowperSymondsWithHeat(const double D, const double p, const double softening, const double heating)
        : D_(D), p_(p), c_(softening), b_(heating)
      {
      }

      HistoryLayout history_layout() const override
      {
        return {{"temperature_rise", HistoryKind::positive, "temperature"}};
      }

      FlowStress evaluate(const FlowStress &slow,
                          const PointFlow &flow,
                          const double *start,
                          double *end) const override
      {
        const double x = flow.growth, relative = flow.rate / D_, power = std::pow(relative, 1. / p_), rate = 1. + power;
        const double infinite = std::numeric_limits<double>::infinity();
        const double rate_slope = x > 0. ? flow.rate_by_growth * power / (p_ * flow.rate) : infinite;
        // s = slow rate (1 - c (T_n + b s x)), linear in s
        const double top = slow.value * rate * (1. - c_ * *start), bottom = 1. + slow.value * rate * c_ * b_ * x;
        const double s = top / bottom;
        *end = *start + b_ * s * x;
        const double cold = slow.value * rate, cold_slope = slow.slope * rate + slow.value * rate_slope;
        const double top_slope = cold_slope * (1. - c_ * *start);
        const double bottom_slope = c_ * b_ * (cold + x * cold_slope);
        if (x > 0.)
          return {s, (top_slope - s * bottom_slope) / bottom};
        return {s, std::numeric_limits<double>::infinity()};
      }

    private:
      double D_, p_, c_, b_;
    };
  } // namespace testing
} // namespace deltaform
