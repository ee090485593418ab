// Growth of voids after J.R. Rice and D.M. Tracey (J. Mech. Phys. Solids 17 (1969) 201), without their factor .283:
//
//   D = integral of exp(3/2 h) dx,   h = mean stress over Mises stress,
//
// so that ln of a void's radius grows by .283 D. By the trapezoidal rule over the increments.
#include <deltaform/materials/point_field.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    class RiceTracey : public PointField
    {
    public:
      RiceTracey(Section &, const PointFieldHost &)
      {
      }

      double growth(const PointStep &step) const override
      {
        const double begin = std::exp(1.5 * triaxiality(step.stress_before));
        return .5 * (begin + std::exp(1.5 * triaxiality(step.stress))) * step.equivalent;
      }
    };

    const PointFields::Entry entry("rice-tracey", "Growth of voids: integral of exp(3/2 mean stress/Mises stress) over "
                                                  "the flow",
                                   make_as<RiceTracey, PointField, const PointFieldHost &>);
  } // namespace
} // namespace deltaform
