#include "hosford_return.h"

#include <deltaform/materials/yield_surface.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace deltaform
{
  namespace
  {
    /**
     * Logan and Hosford, normal anisotropy r >= 0, exponent a >= 2 (6 for bcc, 8 for fcc metals; 2 is Hill 1948):
     *
     *     (1 + r) q^a = |s1 - s3|^a + |s2 - s3|^a + r |s1 - s2|^a,
     *
     * s1, s2 principal in the sheet, s3 along its normal. Below a = 2 the curvature of the surface is unbounded. R.W.
     * Logan, W.F. Hosford, Upper-bound anisotropic yield locus calculations assuming <111>-pencil glide, Int. J. Mech.
     * Sci. 22 (1980) 419.
     *
     * With p1, p2 principal across the third axis, in the sheet as in the section of a solid it is one of
     *
     *     (1 + r) q^a = across (|p1 - t3|^a + |p2 - t3|^a) + between |p1 - p2|^a + one |t_k - t3|^a,
     *
     * k the direction in the sheet if r > 1, its normal if not. The choice matters under shear through the thickness
     * only, about which r says nothing: it is convex, and isotropic for r = 1.
     */
    class Hosford : public YieldSurface
    {
    public:
      struct Weights
      {
        double across, between, one;
        unsigned int direction; ///< k
      };

      Hosford(const double exponent, const double r, const Weights &weights, const Symmetry symmetry)
        : a_(exponent), r_(r), weights_(weights), symmetry_(symmetry)
      {
      }

      double equivalent_stress(const Mandel &t) const override
      {
        return size(principal(t));
      }

      YieldPoint evaluate(const Mandel &t) const override;

      Symmetry symmetry() const override
      {
        return symmetry_;
      }

      std::unique_ptr<YieldSurface> in_section() const override
      {
        const Weights weights{std::min(1., r_), 1., std::abs(1. - r_), r_ > 1. ? 0u : 1u};
        return std::make_unique<Hosford>(a_, r_, weights, Symmetry::orthotropic);
      }

      const ReturnMap *closed_form(const ThirdDirection third) const override
      {
        return third == ThirdDirection::stress_given ? in_sheet_.get() : nullptr;
      }

      /// Of a sheet; of the same surface.
      void set_closed_form(std::unique_ptr<HosfordReturn> in_sheet)
      {
        in_sheet_ = std::move(in_sheet);
      }

    private:
      /// Both principal stresses across the third axis and t_k, against the third stress, and cosine and sine of twice
      /// the angle of the first one.
      struct Principal
      {
        double first, second, single, cosine, sine;
      };

      Principal principal(const Mandel &t) const
      {
        const double mean = (t[0] + t[1]) / 2. - t[2], half = (t[0] - t[1]) / 2., shear = t[3] / std::sqrt(2.);
        const double radius = std::hypot(half, shear), single = t[weights_.direction] - t[2];
        if (!(radius > 0.))
          return {mean, mean, single, 1., 0.};
        return {mean + radius, mean - radius, single, half / radius, shear / radius};
      }

      double size(const Principal &s) const
      {
        const double largest = std::max({std::abs(s.first), std::abs(s.second), s.first - s.second});
        if (!(largest > 0.))
          return largest; // zero, or not a number
        const auto power = [&](const double z) { return std::pow(std::abs(z) / largest, a_); };
        double sum = weights_.across * (power(s.first) + power(s.second));
        sum += weights_.between * power(s.first - s.second);
        if (weights_.one > 0.)
          sum += weights_.one * power(s.single);
        return largest * std::pow(sum / (1. + r_), 1. / a_);
      }

      double a_, r_;
      Weights weights_;
      Symmetry symmetry_;
      std::unique_ptr<HosfordReturn> in_sheet_;
    };


    YieldPoint Hosford::evaluate(const Mandel &t) const
    {
      const Principal s = principal(t);
      YieldPoint at{size(s), {}, {}};
      const double q = at.value, z1 = s.first / q, z2 = s.second / q, z12 = z1 - z2, z = s.single / q;
      // |z|^(a-2) of all differences: times z the gradient, times a - 1 the curvature
      const auto power = [&](const double weight, const double difference) {
        return weight > 0. ? weight / (1. + r_) * std::pow(std::abs(difference), a_ - 2.) : 0.;
      };
      const double p1 = power(weights_.across, z1), p2 = power(weights_.across, z2), p12 = power(weights_.between, z12);
      const double p = power(weights_.one, z), curvature = (a_ - 1.) / q;
      const double g1 = p1 * z1 + p12 * z12, g2 = p2 * z2 - p12 * z12;
      // Where the principal stresses turn: (g1 - g2)/(p1 - p2), by its limit where they are equal
      const double turning = z12 > 1e-6 ? (g1 - g2) / (q * z12) : curvature * ((p1 + p2) / 2. + 2. * p12);

      // Directions of both principal stresses, of t_k, and of the shear between the principal ones
      const double c = s.cosine / 2., d = s.sine / std::sqrt(2.);
      const Mandel n1{{.5 + c, .5 - c, -1., d}}, n2{{.5 - c, .5 + c, -1., -d}}, shear{{-d, d, 0., s.cosine}};
      const Mandel n{{weights_.direction == 0 ? 1. : 0., weights_.direction == 1 ? 1. : 0., -1., 0.}};
      for (unsigned int i = 0; i < 4; ++i)
        at.gradient[i] = g1 * n1[i] + g2 * n2[i] + p * z * n[i];
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          at.hessian[4 * i + j] =
            curvature * (p1 * n1[i] * n1[j] + p2 * n2[i] * n2[j] + p12 * (n1[i] - n2[i]) * (n1[j] - n2[j]) +
                         p * n[i] * n[j] - at.gradient[i] * at.gradient[j]) +
            turning * shear[i] * shear[j];
      return at;
    }


    std::unique_ptr<YieldSurface> make(Section &section)
    {
      const double exponent =
        section.number("Exponent", required(8.), Range::between(2., 50.), "1", "a: 6 for bcc, 8 for fcc metals.");
      const double r = section.number("r-bar",
                                      1.,
                                      Range::not_negative(),
                                      "1",
                                      "Normal anisotropy: strain across over strain through the sheet in tension.");
      const Symmetry symmetry = r == 1. ? Symmetry::isotropic : Symmetry::about_third_axis;
      const auto surface = [&]() {
        return std::make_unique<Hosford>(exponent, r, Hosford::Weights{1., r, 0., 0}, symmetry);
      };
      auto result = surface();
      result->set_closed_form(std::make_unique<HosfordReturn>(exponent, r, surface()));
      return result;
    }

    const Registry<YieldSurface>::Entry entry("hosford", "Logan and Hosford: (1+r) q^a = |t1|^a + |t2|^a + r |t1-t2|^a",
                                              make);
  } // namespace
} // namespace deltaform
