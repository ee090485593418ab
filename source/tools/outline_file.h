#pragma once
// Outlines in files; private to the tools.
#include "outline_path.h"

#include <istream>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Points, one a line: 'r z' is reached by a straight line, 'r z center_r center_z cw' (or ccw) by an arc about a
   * center, clockwise or counterclockwise. Numbers are separated by blanks or commas; # begins a comment.
   * @throws std::invalid_argument naming the line
   */
  std::vector<OutlinePiece> read_points(std::istream &file);

  /**
   * LINE, ARC and LWPOLYLINE (with bulges) of the section ENTITIES of an ASCII DXF file; x is r, y is z. Other entities
   * are passed over. @param layer of which they are read; empty: of all
   * @throws std::invalid_argument if it is no such file, or has none of these
   */
  std::vector<OutlinePiece> read_dxf(std::istream &file, const std::string &layer);
} // namespace deltaform
