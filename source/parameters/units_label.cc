#include <deltaform/parameters/section.h>
#include <deltaform/parameters/units_label.h>

namespace deltaform
{
  std::string read_units_label(const Section &scene)
  {
    Section root = scene.root();
    return root.text("Units",
                     Default<std::string>("consistent"),
                     "Label of the units, for example 'mm, N, MPa'; with that of the time, 'mm, N, MPa, s', where a "
                     "material depends on the rate of strain.");
  }
} // namespace deltaform
