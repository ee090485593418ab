// Rise of the temperature of a metal whose heat stays where the flow makes it.
#include <deltaform/materials/point_field.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    class TemperatureRise : public PointField
    {
    public:
      std::string unit() const override
      {
        return "temperature";
      }

      double growth(const PointStep &step) const override
      {
        return step.warming;
      }
    };

    std::unique_ptr<PointField> make(Section &section, const PointFieldHost &host)
    {
      if (!keeps_its_heat(host.law) && !section.documentation())
        section.root().sub("Limits").fail("Criteria",
                                          "'temperature rise' wants Material/Heat/Adiabatic = true, and no "
                                          "Conductivity: heat that flows is in the columns of heat");
      return std::make_unique<TemperatureRise>();
    }

    const PointFields::Entry
      entry("temperature rise", "Rise of the temperature by the heat of flow; always there for adiabatic metals", make);
  } // namespace
} // namespace deltaform
