#include <deltaform/checks/idle_stage.h>

namespace deltaform
{
  bool changes_anything(const Actors &actors, const Stage &stage, const Stage *const before)
  {
    const auto varies = [&](const TimeFunction &function) {
      if (function.is_constant())
        return false;
      for (unsigned int k = 1; k <= 50; ++k)
        if (function(stage.begin + (stage.end - stage.begin) * k / 50) != function(stage.begin))
          return true;
      return false;
    };
    const auto grows = [&](const TimeFunction &function) {
      return varies(function) || (!before && function(stage.end) != 0);
    };
    // What held the blank in the earlier operation goes; so does the pull of what was trimmed.
    bool changes = !before && actors.formed_before;
    for (const auto &tool : actors.tools)
    {
      const bool exists = tool->exists_in(stage.name);
      const auto range = tool->travel_range(stage.begin, stage.end);
      changes |= exists && (range.first != range.second || tool->force_driven());
      changes |= before && tool->exists_in(before->name) != exists;
    }
    for (const auto &support : actors.supports)
    {
      const bool acts = support.acts_in(stage.name);
      if (acts && !support.hold)
        for (const auto &value : support.values.empty() ? std::vector<TimeFunction>{support.value} : support.values)
          changes |= grows(value);
      changes |= before && support.acts_in(before->name) != acts;
    }
    for (const auto &load : actors.loads)
    {
      const bool acts = load->acts_in(stage.name);
      changes |= acts && grows(load->value());
      changes |= before && load->acts_in(before->name) != acts;
    }
    return changes;
  }
} // namespace deltaform
