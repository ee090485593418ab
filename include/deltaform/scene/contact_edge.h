#pragma once

#include <deltaform/blanks/blank.h>

namespace deltaform
{
  /// What `edge` means in a scene: the shortest distance between neighbouring nodes that may touch a tool, of the first
  /// mesh [length]. A blank without such edges has its thickness.
  double shortest_contact_edge(const Blank &blank);
} // namespace deltaform
