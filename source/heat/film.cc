#include <deltaform/heat/film.h>
#include <deltaform/heat/temperature_outside.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

#include <algorithm>

namespace deltaform
{
  Film::Film(Section section, Blank &blank)
    : parts_(section.names("Boundaries", "", "Parts of the blank's boundary, such as bottom, top, start, end.")),
      coefficient_(section.number("Film coefficient", required(.01), Range::not_negative(),
                                  "force/length/time/temperature",
                                  "h, for convection and radiation together; in mm, N, s: N/(mm s K), which is 1000 "
                                  "W/(m2 K).")),
      rise_(rise_outside(section, blank.conducting() != nullptr ? blank.conducting()->metal() : MetalHeat(),
                         "Of the surroundings; default is that of the blank at its start."))
  {
    if (section.documentation())
      return;
    const auto all = blank.boundary().parts();
    if (parts_.empty())
      section.fail("Boundaries", "name the parts of the boundary that exchange heat: " + text::join(all, ", "));
    for (const auto &part : parts_)
      if (std::find(all.begin(), all.end(), part) == all.end())
        section.fail("Boundaries", "the blank has no '" + part + "', only " + text::join(all, ", "));
  }
} // namespace deltaform
