#include <deltaform/materials/softening.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /**
     * Johnson and Cook: 1 - ((T - T0)/(Tm - T0))^m, T0 the temperature at the start, Tm that of melting, m > 0; 0 from
     * Tm on, 1 below T0. G.R. Johnson, W.H. Cook, Proc. 7th Int. Symp. Ballistics (1983) 541.
     */
    class JohnsonCookSoftening final : public Softening
    {
    public:
      explicit JohnsonCookSoftening(Section &section)
      {
        const std::string melting = "Melting temperature";
        m_ = section.number("Softening exponent", required(1.09), Range::positive(), "1",
                            "m in 1 - ((T - T0)/(Tm - T0))^m.");
        const double start = section.number(
          "Initial temperature", required(298.), Range::any(), "temperature",
          "T0, in the unit of the melting temperature.");
        range_ = section.number(melting, required(1356.), Range::any(), "temperature", "Tm, above T0.") - start;
        if (!(range_ > 0.))
          section.fail(melting, "the metal would be molten from the start: must lie above the initial temperature.");
      }

      Softened evaluate(const double rise) const override
      {
        const double relative = rise / range_;
        if (relative >= 1.)
          return {0., 0.};
        if (relative < 0.)
          return {1., 0.};
        // The slope at no rise at all is infinite for m < 1: that of a very small one.
        const double power = std::pow(std::max(relative, 0.), m_), near = std::max(relative, 1e-12);
        return {1. - power, -m_ * std::pow(near, m_ - 1.) / range_};
      }

      double melting_rise() const override
      {
        return range_;
      }

    private:
      double m_ = 1., range_ = 1.;
    };

    const Registry<Softening>::Entry
      entry("johnson-cook", "1 - ((T - T0)/(Tm - T0))^m", make_as<JohnsonCookSoftening, Softening>);
  } // namespace
} // namespace deltaform
