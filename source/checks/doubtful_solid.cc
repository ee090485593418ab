#include <deltaform/checks/doubtful_solid.h>
#include <deltaform/parameters/text.h>
#include <deltaform/tools/shape.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  std::vector<ToolWall> walls_along_z(const std::string &tool, const Side side, const Shape &shape)
  {
    std::vector<ToolWall> walls;
    for (const Segment &segment : shape.segments())
      if (segment.kind == Segment::Kind::line && std::abs(segment.tangent[0]) < 1e-6)
      {
        const bool endless = std::isinf(segment.first) || std::isinf(segment.last);
        walls.push_back(
          // The normal is the tangent turned to the left; a shape that is mirrored in z keeps its r.
          {tool,
           side,
           segment.start[0],
           endless ? std::numeric_limits<double>::infinity() : segment.length,
           segment.tangent[1] < 0});
      }
    return walls;
  }


  std::vector<std::string> doubtful_solid(const double thickness, const std::vector<ToolWall> &walls)
  {
    constexpr double shortest = 5.; // thicknesses: the land of a real ironing ring is shorter
    constexpr double fits = 1. - 1e-3; // of a thickness: a gap of one thickness irons nothing
    std::vector<std::string> findings;
    for (const ToolWall &inner : walls)
      for (const ToolWall &outer : walls)
      {
        const double gap = outer.r - inner.r;
        if (inner.side == outer.side || !inner.outward || outer.outward || !(gap > 0.) || !(gap < fits * thickness) ||
            std::min(inner.length, outer.length) <= shortest * thickness)
          continue;
        findings.push_back("tools '" + inner.tool + "' and '" + outer.tool + "' iron the blank, which is " +
                           text::rounded(thickness) + " thick, to " + text::rounded(gap) +
                           " between long parallel walls. Behind the ironing zone they grip it elastically, and a mesh "
                           "of a few cells across does not find that force: with degree 1 it is much too large, with "
                           "degree 2 too small. Let the die open behind a land of a few thicknesses, as ironing rings "
                           "do (Shape = profile), or do not use forces after the blank's end has passed the zone");
      }
    return findings;
  }
} // namespace deltaform
