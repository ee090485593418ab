#pragma once

#include <deltaform/base/section.h>
#include <deltaform/scene/stage.h>
#include <deltaform/tools/tool.h>

#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  /// What is written, and when.
  struct OutputSettings
  {
    OutputSettings(Section &section, const std::vector<std::unique_ptr<Tool>> &tools, const std::vector<Stage> &stages);

    std::string folder;
    unsigned int main_tool = invalid_index; ///< index of the tool whose travel names the files
    std::vector<double> travels;            ///< at which tables are written
    std::vector<double> travel_times;       ///< the times that belong to them
    std::vector<double> frame_times;        ///< of the pictures, ascending
  };
} // namespace deltaform
