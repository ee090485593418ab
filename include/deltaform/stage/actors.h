#pragma once

#include <deltaform/blanks/blank.h>
#include <deltaform/contact/contact_interface.h>
#include <deltaform/heat/heat_flow.h>
#include <deltaform/limits/flange_wrinkling.h>
#include <deltaform/limits/limit.h>
#include <deltaform/loads/load.h>
#include <deltaform/loads/support.h>
#include <deltaform/measures/probe.h>
#include <deltaform/stage/stage.h>

#include <memory>
#include <vector>

namespace deltaform
{
  /// What the scene names, built in dependency order; shared by the parts that run it.
  struct Actors
  {
    /// Is every penetration measured by the delta that is allowed?
    bool keeps_promise() const
    {
      return contact && contact->normal_law->uses_penalty();
    }

    /// The run has skipped time: whatever follows a function of time goes on from where it was.
    void skip(const SkippedTime &skipped)
    {
      for (auto &tool : tools)
        tool->skip(skipped);
      for (auto &support : supports)
        support.skipped = skipped;
      for (auto &load : loads)
        load->skip(skipped);
    }

    bool formed_before = false; ///< does the blank begin as an earlier operation left it?
    std::unique_ptr<Blank> blank;
    std::vector<std::unique_ptr<Tool>> tools;
    std::unique_ptr<ContactSettings> contact;
    std::vector<std::unique_ptr<ContactInterface>> interfaces; ///< one per tool, in the order of the tools
    std::unique_ptr<HeatFlow> heat; ///< null: heat stays where it is made, or is not counted
    std::vector<Support> supports;
    std::vector<std::unique_ptr<Load>> loads;
    std::vector<Stage> stages;
    std::vector<Probe> probes;
    std::vector<Limit> limits;
    std::unique_ptr<FlangeWrinkling> wrinkling; ///< null: not asked for
  };
} // namespace deltaform
