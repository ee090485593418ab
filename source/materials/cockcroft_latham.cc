// Damage of M.G. Cockcroft and D.J. Latham (J. Inst. Metals 96 (1968) 33): the largest tensile stress times the flow,
//
//   D = integral of max(s1, 0) dx   (stress),
//
// s1 the largest principal Kirchhoff stress, by the trapezoidal rule over the increments.
#include <deltaform/materials/point_field.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class CockcroftLatham : public PointField
    {
    public:
      CockcroftLatham(Section &, const PointFieldHost &)
      {
      }

      std::string unit() const override
      {
        return "stress";
      }

      double growth(const PointStep &step) const override
      {
        const double begin = std::max(largest_principal(step.stress_before), 0.);
        return .5 * (begin + std::max(largest_principal(step.stress), 0.)) * step.equivalent;
      }
    };

    const PointFields::Entry entry("cockcroft-latham", "Integral of the largest tensile stress over the flow",
                                   make_as<CockcroftLatham, PointField, const PointFieldHost &>);
  } // namespace
} // namespace deltaform
