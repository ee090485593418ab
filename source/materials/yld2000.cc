#include <deltaform/materials/yield_surface.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace deltaform
{
  namespace
  {
    /**
     * Yld2000-2d, in plane stress against the third stress, x = t1 - t3 along the rolling direction, y = t2 - t3, s =
     * t12:
     *
     *     2 q^a = |X'1 - X'2|^a + |2 X''2 + X''1|^a + |2 X''1 + X''2|^a,
     *
     * X' and X'' linear in the stress with alpha 1, 2, 7 and 3 to 6, 8, of which the principal values count. All alpha
     * 1: Hosford with r = 1. Here 2 R' = X'1 - X'2, and S and R are mean and half difference of X''1, X''2. F. Barlat
     * et al., Plane stress yield function for aluminum alloy sheets - part 1: theory, Int. J. Plasticity 19 (2003)
     * 1297.
     */
    class Yld2000 : public YieldSurface
    {
    public:
      /// @p alpha eight; @p rolling the direction, 0 or 1, that is the rolling direction
      Yld2000(const double exponent, const std::vector<double> &alpha, const unsigned int rolling)
        : a_(exponent)
      {
        const unsigned int x = rolling, y = 1 - rolling;
        const double a3 = alpha[2], a4 = alpha[3], a5 = alpha[4], a6 = alpha[5];
        const double xx = (-2. * a3 + 2. * a4 + 8. * a5 - 2. * a6) / 9., xy = (a3 - 4. * a4 - 4. * a5 + 4. * a6) / 9.;
        const double yx = (4. * a3 - 4. * a4 - 4. * a5 + a6) / 9., yy = (-2. * a3 + 8. * a4 + 2. * a5 - 2. * a6) / 9.;
        first_half_[x] = (2. * alpha[0] + alpha[1]) / 6.;
        first_half_[y] = -(alpha[0] + 2. * alpha[1]) / 6.;
        first_shear_ = alpha[6];
        half_[x] = (xx - yx) / 2.;
        half_[y] = (xy - yy) / 2.;
        mean_[x] = (xx + yx) / 2.;
        mean_[y] = (xy + yy) / 2.;
        shear_ = alpha[7];
      }

      double equivalent_stress(const Mandel &t) const override
      {
        return size(values(t));
      }

      YieldPoint evaluate(const Mandel &t) const override;

      bool serves(const ThirdDirection third) const override
      {
        return third == ThirdDirection::stress_given;
      }

    private:
      /// Half of X'xx - X'yy and X'xy, their length R'; the same of X'', and its mean S.
      struct Values
      {
        double first_half, first_shear, first_radius, half, shear, radius, mean;
      };

      Values values(const Mandel &t) const
      {
        const double x = t[0] - t[2], y = t[1] - t[2], s = t[3] / std::sqrt(2.);
        Values v{first_half_[0] * x + first_half_[1] * y, first_shear_ * s, 0., half_[0] * x + half_[1] * y, shear_ * s,
                 0., mean_[0] * x + mean_[1] * y};
        v.first_radius = std::hypot(v.first_half, v.first_shear);
        v.radius = std::hypot(v.half, v.shear);
        return v;
      }

      double size(const Values &v) const
      {
        const double z1 = 2. * v.first_radius, z2 = std::abs(3. * v.mean - v.radius),
                     z3 = std::abs(3. * v.mean + v.radius), largest = std::max({z1, z2, z3});
        if (!(largest > 0.))
          return largest; // zero, or not a number
        const auto power = [&](const double z) { return to_power(z / largest, a_); };
        return largest * std::pow((power(z1) + power(z2) + power(z3)) / 2., 1. / a_);
      }

      /// z^n, z >= 0; the exponents of metals are whole numbers, whose powers are a few products.
      static double to_power(double z, const double n)
      {
        if (n != std::floor(n))
          return std::pow(z, n);
        double result = 1.;
        for (auto left = static_cast<unsigned int>(n); left != 0; left /= 2, z *= z)
          if (left % 2 == 1)
            result *= z;
        return result;
      }

      /// A linear function of the stress, as its gradient.
      static Mandel gradient(const std::array<double, 2> &direct, const double shear)
      {
        return {{direct[0], direct[1], -direct[0] - direct[1], shear / std::sqrt(2.)}};
      }

      double a_;
      std::array<double, 2> first_half_, half_, mean_; ///< of X' and X'', by x and y
      double first_shear_, shear_;
    };


    YieldPoint Yld2000::evaluate(const Mandel &t) const
    {
      const Values v = values(t);
      YieldPoint at{size(v), {}, {}};
      const double q = at.value, curvature = (a_ - 1.) / q;
      const double z1 = 2. * v.first_radius / q, z2 = (3. * v.mean - v.radius) / q, z3 = (3. * v.mean + v.radius) / q;
      // Halves of |z|^(a-2): times z the gradient, times a - 1 the curvature
      const auto power = [&](const double z) { return .5 * to_power(std::abs(z), a_ - 2.); };
      const double p1 = power(z1), p2 = power(z2), p3 = power(z3);

      // Unit vectors along and across X' and X'', of half difference and shear
      const auto unit = [](const double a, const double b, const double length) {
        return length > 0. ? std::array<double, 2>{{a / length, b / length}} : std::array<double, 2>{{1., 0.}};
      };
      const auto first = unit(v.first_half, v.first_shear, v.first_radius), second = unit(v.half, v.shear, v.radius);
      const Mandel by_first_half = gradient(first_half_, 0.), by_first_shear = gradient({}, first_shear_);
      const Mandel by_half = gradient(half_, 0.), by_shear = gradient({}, shear_), by_mean = gradient(mean_, 0.);
      Mandel n1, n2, n3, first_turn, turn; // gradients of z1, z2, z3; how X' and X'' turn
      for (unsigned int i = 0; i < 4; ++i)
      {
        const double radius = second[0] * by_half[i] + second[1] * by_shear[i];
        n1[i] = 2. * (first[0] * by_first_half[i] + first[1] * by_first_shear[i]);
        n2[i] = 3. * by_mean[i] - radius;
        n3[i] = 3. * by_mean[i] + radius;
        first_turn[i] = first[0] * by_first_shear[i] - first[1] * by_first_half[i];
        turn[i] = second[0] * by_shear[i] - second[1] * by_half[i];
        at.gradient[i] = p1 * z1 * n1[i] + p2 * z2 * n2[i] + p3 * z3 * n3[i];
      }
      // dz/dR over R: by its limit where R is zero
      const double turning =
        v.radius > 1e-6 * q ? (p3 * z3 - p2 * z2) / v.radius : curvature * (p2 + p3);
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          at.hessian[4 * i + j] = curvature * (p1 * n1[i] * n1[j] + p2 * n2[i] * n2[j] + p3 * n3[i] * n3[j] -
                                               at.gradient[i] * at.gradient[j]) +
                                  4. * p1 / q * first_turn[i] * first_turn[j] + turning * turn[i] * turn[j];
      return at;
    }


    std::unique_ptr<YieldSurface> make(Section &section)
    {
      const double exponent =
        section.number("Exponent", required(8.), Range::between(2., 50.), "1", "a: 6 for bcc, 8 for fcc metals.");
      const std::string name = "Alpha";
      const auto rows = section.rows(name,
                                     required("1.0035 .9636 .8832 1.0481 1.0125 .9947 .9215 1.1918"),
                                     8,
                                     "1",
                                     "Coefficients alpha 1 to 8, found with the flow stress as reference stress.");
      if (rows.size() != 1)
        section.fail(name, "must be eight numbers.");
      const auto &alpha = rows.front();
      for (const double value : alpha)
        if (!(value > 0.))
          section.fail(name, "must be positive.");
      const bool along = section.choice("Rolling direction",
                                        "along",
                                        {"along", "across"},
                                        "Rolling direction of a strip in plane strain: along its section or "
                                        "across it.") == "along";
      return std::make_unique<Yld2000>(exponent, alpha, along ? 0 : 1);
    }

    const Registry<YieldSurface>::Entry
      entry("yld2000-2d", "Barlat's surface of plane stress, for a strip in plane strain", make);
  } // namespace
} // namespace deltaform
