#pragma once

#include <deltaform/blanks/blank.h>
#include <deltaform/parameters/skipped_time.h>
#include <deltaform/parameters/time_function.h>

#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /// A prescribed displacement or rotation on a part of the boundary.
  struct Support
  {
    Support(const std::string &name, Section section, const Blank &blank);

    bool acts_in(const std::string &stage) const;

    /// The blank was refined: its unknowns have new numbers.
    void renumber(const Blank &blank);

    /// Value of dofs[i] at a time.
    double at(unsigned int i, double time) const
    {
      return skipped.value(values.empty() ? value : values[i], time);
    }

    std::string name;
    std::string boundary;
    Component component;
    std::vector<DofIndex> dofs;
    TimeFunction value; ///< of the first unknown
    std::vector<TimeFunction> values; ///< of every unknown, where they depend on its place; else empty
    SkippedTime skipped; ///< by the run: the value goes on from where it was
    bool hold; ///< keep the value that the unknown has when the stage begins
    std::vector<std::string> stages;
  };
} // namespace deltaform
