#pragma once

#include <deltaform/base/drawing.h>
#include <deltaform/results/picture_series.h>
#include <deltaform/results/units.h>

#include <string>

namespace deltaform
{
  /**
   * Write a drawing as an unstructured grid for ParaView, whole or not at all. Fields are called "name [unit]", with
   * "[-]" for pure numbers; a field of two components becomes a vector of three. Every cell gets points of its own, on
   * which the fields per cell are constant.
   * @throws SceneError if the file cannot be written.
   */
  void write_vtu(const std::string &path, const Drawing &drawing, const Units &units);
} // namespace deltaform
