#pragma once

#include <deltaform/assembly/side.h>

#include <string>
#include <vector>

namespace deltaform
{
  class Shape;

  /// A straight part of a tool along z, on which a wall of the blank slides.
  struct ToolWall
  {
    std::string tool;
    Side side = Side::top; ///< of the blank that the tool touches
    double r = 0; ///< place of the wall [length]
    double length = 0; ///< along z [length]; infinite if it goes on for ever
    bool outward = false; ///< does it face growing r? The blank is on that side of it.
  };

  /// The walls along z of a tool's shape.
  std::vector<ToolWall> walls_along_z(const std::string &tool, Side side, const Shape &shape);

  /**
   * What the results of a solid cannot be trusted in, as sentences for the user; empty if nothing is found. Found is:
   * two tools on opposite sides whose walls face each other closer than the blank is thick [length], both longer than
   * five thicknesses. They iron the blank and then grip it elastically all along, with a force that meshes of usual
   * fineness do not find (doc/theory/solid.md).
   */
  std::vector<std::string> doubtful_solid(double thickness, const std::vector<ToolWall> &walls);
} // namespace deltaform
