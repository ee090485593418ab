#include <deltaform/limits/ironing.h>
#include <deltaform/parameters/text.h>

namespace deltaform
{
  void IroningWatch::observe(const std::vector<SheetSection> &sections)
  {
    worst_.clear();
    double worst = suspicious;
    for (std::size_t i = 0; i < sections.size(); ++i)
    {
      const SheetSection &section = sections[i];
      if (!(section.flow_stress > 0. && section.clamping_pressure > worst * section.flow_stress))
        continue;
      worst = section.clamping_pressure / section.flow_stress;
      worst_ = "node " + std::to_string(i) + " at R0 = " + text::rounded(section.place) +
               " is pressed on both faces with " + text::rounded(section.clamping_pressure) +
               (worst > 1. ? ", more than its flow stress of " : ", close to its flow stress of ") +
               text::rounded(section.flow_stress) +
               ": the tools iron the sheet here, and a shell does not flow through its thickness";
    }
    n_pressed_ = worst > 1. ? n_pressed_ + 1 : 0;
  }
} // namespace deltaform
