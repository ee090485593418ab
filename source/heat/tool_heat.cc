#include <deltaform/heat/temperature_outside.h>
#include <deltaform/heat/tool_heat.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  ToolHeat::ToolHeat(Section section, const MetalHeat &metal)
    : rise_(rise_outside(section, metal, "Of the tool at its start; default is that of the blank.")),
      conductance_(section.number("Conductance", 0., Range::not_negative(), "force/length/time/temperature",
                                  "h0, of heat between blank and tool where they touch; in mm, N, s: N/(mm s K), which "
                                  "is 1000 W/(m2 K). 0: the tool takes none.")),
      exponent_(section.number("Pressure exponent", 0., Range::not_negative(), "1",
                               "m: the conductance is h0 (p/p0)^m at the contact pressure p. 0: it is h0.")),
      reference_pressure_(section.number("Reference pressure", 1., Range::positive(), "stress",
                                         "p0. To be stated with a Pressure exponent.")),
      largest_(section.number("Largest conductance", 100. * conductance_, Range::not_negative(),
                              "force/length/time/temperature",
                              "The conductance does not grow further; default is 100 h0."))
  {
    if (exponent_ > 0. && !section.given("Reference pressure") && !section.documentation())
      section.fail("Reference pressure", "a conductance that depends on the pressure has one at which it is h0: state "
                                         "it beside the Pressure exponent.");
    const double own = std::sqrt(metal.conductivity * metal.capacity);
    const double tool = section.number("Effusivity", own, Range::not_negative(), "force/length/temperature/time^0.5",
                                       "sqrt(k rho c) of the tool, which shares the heat of friction; default is that "
                                       "of the blank: half of it each. 0: the blank takes all.");
    blank_share_ = own / (own + tool);
    const std::string body =
      section.choice("Body", "constant temperature", {"constant temperature", "half space"},
                     "constant temperature: the tool keeps it. half space: it warms as a half-space of its Effusivity; "
                     "heat flows along the normal of each touching point.");
    if (body != "half space")
      return;
    if (!(tool > 0.))
      section.fail("Effusivity", "a half-space takes heat: its sqrt(k rho c) is positive.");
    effusivity_ = tool;
  }


  double ToolHeat::conductance(const double pressure) const
  {
    if (exponent_ == 0.)
      return conductance_;
    return std::min(largest_, conductance_ * std::pow(std::max(pressure, 0.) / reference_pressure_, exponent_));
  }
} // namespace deltaform
