#include "closed_returns.h"

#include <deltaform/materials/yield_surface.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <cmath>
#include <limits>
#include <utility>

namespace deltaform
{
  namespace
  {
    /**
     * Hill 1948, q^2 = F (t2-t3)^2 + G (t3-t1)^2 + H (t1-t2)^2 + 2 N t12^2, in tension along direction 1 the stress
     * itself if G + H = 1. R. Hill, A theory of the yielding and plastic flow of anisotropic metals, Proc. R. Soc. A
     * 193 (1948) 281, whose order of F, G, H this is: F belongs to the plane of directions 2 and 3 (others differ).
     */
    class Hill : public YieldSurface
    {
    public:
      struct Coefficients
      {
        double F, G, H, N;
      };

      Hill(const Coefficients &c, const Symmetry symmetry)
        : P_({{c.G + c.H, -c.H, -c.G, 0., -c.H, c.F + c.H, -c.F, 0., -c.G, -c.F, c.F + c.G, 0., 0., 0., 0., c.N}}),
          symmetry_(symmetry)
      {
      }

      double equivalent_stress(const Mandel &t) const override
      {
        const Mandel Pt = product(t);
        return std::sqrt(t[0] * Pt[0] + t[1] * Pt[1] + t[2] * Pt[2] + t[3] * Pt[3]);
      }

      YieldPoint evaluate(const Mandel &t) const override
      {
        YieldPoint at{equivalent_stress(t), product(t), {}};
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

      const std::array<double, 16> *quadratic_form() const override
      {
        return &P_;
      }

    private:
      Mandel product(const Mandel &t) const
      {
        const Mandel s{{t[0] - t[2], t[1] - t[2], 0., t[3]}}; // a pressure changes nothing, to the last digit
        Mandel result{};
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int j = 0; j < 4; ++j)
            result[i] += P_[4 * i + j] * s[j];
        return result;
      }

      std::array<double, 16> P_;
      Symmetry symmetry_;
    };


    /// A sheet with the coefficients @p c, in the axes of a solid's section: 2 and 3 change places. To shear across the
    /// thickness it resists as an isotropic one does, s/sqrt 3: the r of the sheet say nothing about it.
    std::unique_ptr<YieldSurface> hill_in_section(const Hill::Coefficients &c)
    {
      return std::make_unique<Hill>(Hill::Coefficients{c.F, c.H, c.G, 1.5}, Symmetry::orthotropic);
    }


    /// The coefficients of a sheet with @p r_along and @p r_across its direction of reference, 1.
    Hill::Coefficients sheet_coefficients(const double r_along, const double r_across)
    {
      const double G = 1. / (1. + r_along), H = r_along / (1. + r_along);
      const double F = r_along == r_across ? G : H / r_across;
      // Shear in the sheet, which no strip and no body of revolution has: as if r at 45 degrees were the mean.
      return {F, G, H, (F + G) * ((r_along + r_across) / 2. + .5)};
    }


    /// A sheet with the same r in all its directions.
    class NormalAnisotropy final : public Hill
    {
    public:
      explicit NormalAnisotropy(const double r)
        : Hill(sheet_coefficients(r, r), r == 1. ? Symmetry::isotropic : Symmetry::about_third_axis), r_(r),
          shell_(r)
      {
      }

      std::unique_ptr<YieldSurface> in_section() const override
      {
        return hill_in_section(sheet_coefficients(r_, r_));
      }

      const ReturnMap *closed_form(const ThirdDirection third) const override
      {
        return third == ThirdDirection::stress_given ? &shell_ : nullptr;
      }

    private:
      double r_;
      NormalAnisotropyReturn shell_;
    };


    /// A sheet with a rolling direction, which is direction 1 or 2.
    class PlanarAnisotropy final : public Hill
    {
    public:
      explicit PlanarAnisotropy(const Coefficients &coefficients)
        : Hill(coefficients, Symmetry::orthotropic), coefficients_(coefficients)
      {
      }

      std::unique_ptr<YieldSurface> in_section() const override
      {
        return hill_in_section(coefficients_);
      }

    private:
      Coefficients coefficients_;
    };


    std::unique_ptr<YieldSurface> make(Section &section)
    {
      const std::string mean = "r-bar", along = "r0", across = "r90", rolling = "Rolling direction";
      const bool two = section.given(along) || section.given(across);
      double r = 1.;
      if (!two)
        r = section.number(mean,
                           required(1.6),
                           Range::inside(-.5, std::numeric_limits<double>::infinity()),
                           "1",
                           "Normal anisotropy: strain across over strain through the sheet in tension. Or r0 and r90.");
      else if (section.given(mean))
        section.fail(mean, "the sheet has either r-bar or r0 and r90.");
      if (!two && !section.documentation())
        return std::make_unique<NormalAnisotropy>(r);

      const double r0 = section.number(along,
                                       required(r),
                                       Range::positive(),
                                       "1",
                                       "r in tension along the rolling direction; with r90, without r-bar.");
      const double r90 = section.number(
        across, required(r), Range::positive(), "1", "r in tension across the rolling direction, in the sheet.");
      const bool is_along = section.choice(rolling,
                                           "along",
                                           {"along", "across"},
                                           "Rolling direction of a strip in plane strain: along its section or "
                                           "across it. The flow stress is that of tension along it.") == "along";
      if (r0 == r90)
        return std::make_unique<NormalAnisotropy>(r0);
      Hill::Coefficients c = sheet_coefficients(r0, r90);
      if (!is_along)
        std::swap(c.F, c.G);
      return std::make_unique<PlanarAnisotropy>(c);
    }

    const Registry<YieldSurface>::Entry entry("hill", "Hill 1948: anisotropy r-bar, or r0 and r90", make);
  } // namespace
} // namespace deltaform
