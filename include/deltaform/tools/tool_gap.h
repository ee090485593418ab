#pragma once

#include <deltaform/tools/tool.h>

namespace deltaform
{
  /**
   * Distance of the outlines of two tools (length), negative where one is inside the other; infinite if none has a
   * closest point on the other. Between the points of their polylines it is a little more than the least one (arcs are
   * divided into chords of .02 rad).
   * @param reach how far lines that go on for ever are followed
   */
  double tool_gap(const Tool &a, double travel_a, const Tool &b, double travel_b, double reach);
} // namespace deltaform
