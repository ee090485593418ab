#pragma once

#include <deltaform/io/drawing.h>
#include <deltaform/io/picture_series.h>
#include <deltaform/io/units.h>

#include <string>

namespace deltaform
{
  /**
   * Write a drawing as an unstructured grid for ParaView, whole or not at all. Fields are called "name [unit]", with
   * "[-]" for pure numbers. A vector gets a third component, zero; a tensor becomes one of six with named components,
   * in the order that ParaView knows (XX YY ZZ XY YZ XZ).
   * @throws SceneError if the file cannot be written.
   */
  void write_vtu(const std::string &path, const Drawing &drawing, const Units &units);
} // namespace deltaform
