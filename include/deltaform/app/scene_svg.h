#pragma once

#include <iosfwd>

namespace deltaform
{
  class Scene;

  /// Draw the scene at its start as SVG: the blank with its cells, the tools (dashed: where their motions end), and the
  /// supports. Endless tools are cut off a little beyond the blank.
  void draw_svg(const Scene &scene, std::ostream &out);
} // namespace deltaform
