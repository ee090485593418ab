#include "closed_returns.h"

#include <deltaform/materials/yield_surface.h>
#include <deltaform/parameters/registry.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    /**
     * Mises: q = sqrt(3/2) |dev t|. R. v. Mises, Mechanik der festen Koerper im plastisch-deformablen Zustand, Nachr.
     * Ges. Wiss. Goettingen, Math.-Phys. Kl. (1913) 582.
     */
    class Mises : public YieldSurface
    {
    public:
      double equivalent_stress(const Mandel &t) const override
      {
        const Mandel s = deviator(t);
        return std::sqrt(1.5 * (s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + s[3] * s[3]));
      }

      YieldPoint evaluate(const Mandel &t) const override
      {
        const Mandel s = deviator(t);
        YieldPoint result;
        const double q = result.value = equivalent_stress(t);
        for (unsigned int i = 0; i < 4; ++i)
          result.gradient[i] = 1.5 * s[i] / q;
        for (unsigned int i = 0; i < 4; ++i)
          for (unsigned int j = 0; j < 4; ++j)
          {
            const double projection = (i == j ? 1. : 0.) - (i < 3 && j < 3 ? 1. / 3. : 0.);
            result.hessian[4 * i + j] = (1.5 * projection - result.gradient[i] * result.gradient[j]) / q;
          }
        return result;
      }

      Symmetry symmetry() const override
      {
        return Symmetry::isotropic;
      }

      const std::array<double, 16> *quadratic_form() const override
      {
        static const std::array<double, 16> P = {
          {1., -.5, -.5, 0., -.5, 1., -.5, 0., -.5, -.5, 1., 0., 0., 0., 0., 1.5}};
        return &P;
      }

      const ReturnMap *closed_form(const ThirdDirection third) const override
      {
        if (third == ThirdDirection::strain_given)
          return &solid_;
        return &shell_;
      }

    private:
      static Mandel deviator(const Mandel &t)
      {
        const double mean = (t[0] + t[1] + t[2]) / 3.;
        return {{t[0] - mean, t[1] - mean, t[2] - mean, t[3]}};
      }

      RadialReturn solid_;
      PlaneStressReturn shell_;
    };

    std::unique_ptr<YieldSurface> make(Section &)
    {
      return std::make_unique<Mises>();
    }

    const Registry<YieldSurface>::Entry entry("mises", "sqrt(3/2) |dev t|", make);
  } // namespace
} // namespace deltaform
