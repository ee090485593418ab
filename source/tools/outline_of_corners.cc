#include "outline_of_corners.h"

#include <deltaform/parameters/section.h>

#include <utility>

namespace deltaform
{
  void OutlineOfCorners::read_ends(Section &section)
  {
    across_ = section.choice("Across the axis",
                             "auto",
                             {"auto", "true", "false"},
                             "true: an end on r = 0 is no edge, the outline goes on as its mirror image. auto: true "
                             "if the blank is axisymmetric, false in plane strain.");
  }


  void OutlineOfCorners::set_corners(OutlineCorners corners)
  {
    corners_ = std::move(corners);
    build_corners(across_ != "false");
  }


  void OutlineOfCorners::set_plane_strain()
  {
    if (across_ == "auto")
      build_corners(false);
  }


  void OutlineOfCorners::build_corners(const bool across)
  {
    const auto end = [&](const Point2 &point) { return across && point[0] == 0. ? End::axis : End::free; };
    if (corners_.closed)
      build_closed(corners_.points, corners_.radii);
    else
      build(corners_.points, corners_.radii, end(corners_.points.front()), end(corners_.points.back()));
  }
} // namespace deltaform
