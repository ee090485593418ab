#pragma once

#include <deltaform/base/section.h>
#include <deltaform/blanks/blank.h>

#include <string>
#include <vector>

namespace deltaform
{
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
      return values.empty() ? value(time) : values[i](time);
    }

    std::string name;
    std::string boundary;
    Component component;
    std::vector<DofIndex> dofs;
    TimeFunction value; ///< of the first unknown
    std::vector<TimeFunction> values; ///< of every unknown, where they depend on its place; else empty
    bool hold; ///< keep the value that the unknown has when the stage begins
    std::vector<std::string> stages;
  };

  /// A load on the blank.
  struct Load
  {
    enum class Kind : unsigned char
    {
      pressure,
      dead_pressure,
      edge,
      body
    };

    Load(const std::string &name, Section section, const Blank &blank);

    bool acts_in(const std::string &stage) const;

    /// The blank was refined: its unknowns have new numbers.
    void renumber(const Blank &blank);

    /// Add its forces (with their sign in the residual) at a time.
    void assemble(const Blank &blank, const Vector &q, double time, AssemblyTarget &target) const;

    std::string name;
    Kind kind;
    std::string face; ///< of a pressure
    std::string boundary; ///< of an edge load
    Component component = Component::z;
    std::vector<DofIndex> dofs;
    std::vector<double> weights; ///< what a unit load is to each unknown
    TimeFunction value;
    std::vector<std::string> stages;
  };

  /// Does a list of stages (empty: all) hold a stage?
  bool listed(const std::vector<std::string> &stages, const std::string &stage);
} // namespace deltaform
