// Thinning of a sheet: minus the plastic strain along its normal, ln(t0/t) without the elastic part.
#include <deltaform/materials/point_field.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    class Thinning : public PointField
    {
    public:
      Across across() const override
      {
        return Across::mean;
      }

      double growth(const PointStep &step) const override
      {
        return -step.flow[2];
      }
    };

    std::unique_ptr<PointField> make(Section &section, const PointFieldHost &host)
    {
      if (!host.sheet && !section.documentation())
        section.root().sub("Limits").fail("Criteria", "'thinning' is measured across a sheet: it is for shells only");
      return std::make_unique<Thinning>();
    }

    const PointFields::Entry entry("thinning", "Logarithmic strain lost by the thickness of a shell", make);
  } // namespace
} // namespace deltaform
