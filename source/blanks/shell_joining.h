#pragma once

#include "bend_limit.h"
#include "shell_parts.h"

#include <vector>

namespace deltaform
{
  /// Where the halves of an element of a shell are joined again: behind a radius, where the sheet is straight
  /// (doc/theory/shell.md).
  class ShellJoining
  {
  public:
    /// A mesh, element by element.
    struct Elements
    {
      const std::vector<ShellMesh::Part> &parts;
      const std::vector<double> &bends; ///< accepted (rad)
      const std::vector<bool> &were_bent; ///< what was not may still come to a radius
      const std::vector<double> &lengths; ///< undeformed; halved where an element is to be
      const std::vector<bool> &halved; ///< to be
      const std::vector<bool> &short_for_tools; ///< may not be twice as long where it touches a tool
      const std::vector<ShellMesh::Part> &left_alone; ///< whose halves stay
    };

    ShellJoining(const ShellParts &parts, const BendLimit &limit)
      : parts_(parts), limit_(limit)
    {
    }

    /// Does an element bend so much that it, and its neighbours, stay? @param length undeformed
    bool bends(double bend, double length) const;

    /// Those that are to be joined with the next one; none if they are few.
    std::vector<bool> choose(const Elements &elements) const;

  private:
    /// Of an element and the next one.
    bool halves_of_one(const Elements &elements, unsigned int element) const;
    bool straight(const Elements &elements, unsigned int element) const;
    bool graded(const Elements &elements, unsigned int element) const;
    bool same_metal(unsigned int element) const;

    /// Far enough from what bends, is halved or touches a round part.
    std::vector<bool> at_rest(const Elements &elements) const;

    const ShellParts &parts_;
    BendLimit limit_;
  };
} // namespace deltaform
