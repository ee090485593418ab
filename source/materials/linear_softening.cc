#include <deltaform/materials/softening.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    /// 1 - c rise, c >= 0 per degree; 0 where that is negative, above 1 where the metal is cooled.
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

      double melting_rise() const override
      {
        return 1. / c_;
      }

    private:
      double c_;
    };

    const Registry<Softening>::Entry entry("linear", "1 - c (T - T0)", make_as<LinearSoftening, Softening>);
  } // namespace
} // namespace deltaform
