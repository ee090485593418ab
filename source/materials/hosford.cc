#include <deltaform/base/registry.h>
#include <deltaform/materials/yield_surface.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /**
     * Logan and Hosford, normal anisotropy r >= 0, exponent a >= 2 (6 for bcc, 8 for fcc metals; 2 is Hill 1948):
     *
     *     (1 + r) q^a = |s1 - s3|^a + |s2 - s3|^a + r |s1 - s2|^a,
     *
     * s1, s2 principal in the sheet, s3 along its normal, the third axis. Below a = 2 the curvature of the surface is
     * unbounded. R.W. Logan, W.F. Hosford, Upper-bound anisotropic yield locus calculations assuming <111>-pencil
     * glide, Int. J. Mech. Sci. 22 (1980) 419.
     */
    class Hosford : public YieldSurface
    {
    public:
      Hosford(const double exponent, const double r)
        : a_(exponent), r_(r)
      {
      }

      double equivalent_stress(const Mandel &t) const override
      {
        return size(principal(t));
      }

      YieldPoint evaluate(const Mandel &t) const override;

      Symmetry symmetry() const override
      {
        return r_ == 1. ? Symmetry::isotropic : Symmetry::about_third_axis;
      }

    private:
      /// Both principal stresses across the third axis, against the third one, and cosine and sine of twice the angle
      /// of the first one.
      struct Principal
      {
        double first, second, cosine, sine;
      };

      static Principal principal(const Mandel &t)
      {
        const double mean = (t[0] + t[1]) / 2. - t[2], half = (t[0] - t[1]) / 2., shear = t[3] / std::sqrt(2.);
        const double radius = std::hypot(half, shear);
        if (!(radius > 0.))
          return {mean, mean, 1., 0.};
        return {mean + radius, mean - radius, half / radius, shear / radius};
      }

      double size(const Principal &s) const
      {
        const double largest = std::max({std::abs(s.first), std::abs(s.second), s.first - s.second});
        if (!(largest > 0.))
          return largest; // zero, or not a number
        const auto power = [&](const double z) { return std::pow(std::abs(z) / largest, a_); };
        return largest *
               std::pow((power(s.first) + power(s.second) + r_ * power(s.first - s.second)) / (1. + r_), 1. / a_);
      }

      double a_, r_;
    };


    YieldPoint Hosford::evaluate(const Mandel &t) const
    {
      const Principal s = principal(t);
      YieldPoint at{size(s), {}, {}};
      const double q = at.value, z1 = s.first / q, z2 = s.second / q, z12 = z1 - z2, weight = 1. / (1. + r_);
      // |z|^(a-2) of the three differences: times z the gradient, times a - 1 the curvature
      const double p1 = weight * std::pow(std::abs(z1), a_ - 2.), p2 = weight * std::pow(std::abs(z2), a_ - 2.);
      const double p12 = r_ * weight * std::pow(z12, a_ - 2.);
      const double g1 = p1 * z1 + p12 * z12, g2 = p2 * z2 - p12 * z12;
      const double curvature = (a_ - 1.) / q;
      const double h11 = curvature * (p1 + p12 - g1 * g1), h22 = curvature * (p2 + p12 - g2 * g2);
      const double h12 = -curvature * (p12 + g1 * g2);
      // Where the principal stresses turn: (g1 - g2)/(s1 - s2), by its limit where they are equal
      const double turning = z12 > 1e-6 ? (g1 - g2) / (q * z12) : curvature * ((p1 + p2) / 2. + 2. * p12);

      // Directions of both principal stresses, and of the shear between them
      const double c = s.cosine / 2., d = s.sine / std::sqrt(2.);
      const Mandel n1{{.5 + c, .5 - c, -1., d}}, n2{{.5 - c, .5 + c, -1., -d}}, shear{{-d, d, 0., s.cosine}};
      for (unsigned int i = 0; i < 4; ++i)
      {
        at.gradient[i] = g1 * n1[i] + g2 * n2[i];
        for (unsigned int j = 0; j < 4; ++j)
          at.hessian[4 * i + j] = h11 * n1[i] * n1[j] + h22 * n2[i] * n2[j] +
                                  h12 * (n1[i] * n2[j] + n2[i] * n1[j]) + turning * shear[i] * shear[j];
      }
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
      return std::make_unique<Hosford>(exponent, r);
    }

    const Registry<YieldSurface>::Entry entry("hosford", "Logan and Hosford: (1+r) q^a = |t1|^a + |t2|^a + r |t1-t2|^a",
                                              make);
  } // namespace
} // namespace deltaform
