#pragma once

#include <deltaform/blanks/sheet_section.h>

#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Finds out whether two tools iron a shell. The section of a shell has no unknown for its thickness: it can carry a
   * contact pressure on both faces, but it does not flow under one. A section whose faces are both pressed with more
   * than its flow stress (means over one thickness) would be thinned by the tools, and what the shell computes there is
   * wrong. A single increment may overshoot where a node comes under a tool: it takes two in a row.
   */
  class IroningWatch
  {
  public:
    /// @param sections of the blank after an accepted increment; none if it is no sheet
    void observe(const std::vector<SheetSection> &sections);

    /// "node 12 at R0 = 0.9 is pressed on both faces with ...", or empty if no section is ironed.
    std::string finding() const
    {
      return n_pressed_ >= enough_increments ? worst_ : "";
    }

    /// The same of the last increment alone, also if the pressure was only close to the flow stress: what may be the
    /// cause where the next one cannot be solved.
    const std::string &suspicion() const
    {
      return worst_;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &n_pressed_ &worst_;
    }

  private:
    static constexpr unsigned int enough_increments = 2;
    static constexpr double suspicious = .7; ///< share of the flow stress: the next increment may be the one too much

    unsigned int n_pressed_ = 0; ///< increments in a row with a section above its flow stress
    std::string worst_; ///< the section that is furthest above it in the last increment
  };
} // namespace deltaform
