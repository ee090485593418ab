#include <deltaform/base/registry.h>
#include <deltaform/materials/softening.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// The temperature is counted, the flow stress does not care.
    class NoSoftening final : public Softening
    {
    public:
      Softened evaluate(double) const override
      {
        return {1., 0.};
      }
    };


    /// 1 - c rise, c >= 0 per degree; 0 where that is negative.
    class LinearSoftening final : public Softening
    {
    public:
      explicit LinearSoftening(Section &section)
        : c_(section.number("Softening coefficient",
                            required(1e-3),
                            Range::not_negative(),
                            "1/temperature",
                            "Share of the flow stress that a degree takes away."))
      {
      }

      Softened evaluate(const double rise) const override
      {
        const double factor = 1. - c_ * rise;
        return factor > 0. ? Softened{factor, -c_} : Softened{0., 0.};
      }

    private:
      double c_;
    };


    /**
     * Johnson and Cook: 1 - ((T - T0)/(Tm - T0))^m, T0 the temperature at the start, Tm that of melting, m > 0; 0 from
     * Tm on. G.R. Johnson, W.H. Cook, Proc. 7th Int. Symp. Ballistics (1983) 541.
     */
    class JohnsonCookSoftening final : public Softening
    {
    public:
      explicit JohnsonCookSoftening(Section &section)
      {
        const std::string melting = "Melting temperature";
        m_ = section.number("Softening exponent", required(1.09), Range::positive(), "1", "m.");
        const double start = section.number(
          "Initial temperature", required(298.), Range::any(), "temperature", "T0, in the unit of the other.");
        range_ = section.number(melting, required(1356.), Range::any(), "temperature", "Tm, above T0.") - start;
        if (!(range_ > 0.))
          section.fail(melting, "the metal would be molten from the start: must lie above the initial temperature.");
      }

      Softened evaluate(const double rise) const override
      {
        const double relative = rise / range_;
        if (relative >= 1.)
          return {0., 0.};
        // The slope at no rise at all is infinite for m < 1: that of a very small one.
        const double power = std::pow(std::max(relative, 0.), m_), near = std::max(relative, 1e-12);
        return {1. - power, -m_ * std::pow(near, m_ - 1.) / range_};
      }

    private:
      double m_ = 1., range_ = 1.;
    };

    std::unique_ptr<Softening> make_none(Section &)
    {
      return std::make_unique<NoSoftening>();
    }

    const Registry<Softening>::Entry none("none", "The flow stress does not depend on the temperature", make_none);
    const Registry<Softening>::Entry linear("linear", "1 - c (T - T0)", make_as<LinearSoftening, Softening>);
    const Registry<Softening>::Entry
      johnson_cook("johnson-cook", "1 - ((T - T0)/(Tm - T0))^m", make_as<JohnsonCookSoftening, Softening>);
  } // namespace
} // namespace deltaform
