#include <deltaform/heat/temperature_outside.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

namespace deltaform
{
  double rise_outside(Section &section, const MetalHeat &metal, const std::string &sentence)
  {
    const double temperature =
      section.number("Temperature", metal.initial_temperature, Range::any(), "temperature", sentence);
    const double rise = temperature - metal.initial_temperature;
    if (rise >= metal.melting_rise)
      section.fail("Temperature", "the metal of the blank would melt: it carries nothing from " +
                                    text::rounded(metal.initial_temperature + metal.melting_rise) +
                                    " on (Material/Heat/Softening).");
    return rise;
  }
} // namespace deltaform
