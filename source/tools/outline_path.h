#pragma once
// A path of lines and arcs as corner points with fillets; private to the tools.
#include <deltaform/assembly/types.h>

#include <vector>

namespace deltaform
{
  /// A line (bulge 0) or an arc of an outline. The bulge is that of DXF: tan(angle/4), positive to the left.
  struct OutlinePiece
  {
    Point2 start, end;
    double bulge = 0;

    OutlinePiece reversed() const
    {
      return {end, start, -bulge};
    }
  };

  /// An arc about @p center, counterclockwise or not.
  OutlinePiece arc_about(const Point2 &center, const Point2 &start, const Point2 &end, bool counterclockwise);

  /**
   * Pieces in any order and direction, joined to one path that begins as the first of them goes (or where the path has
   * an end). @param tolerance distance of ends that are the same point
   * @throws std::invalid_argument if they are no single path
   */
  std::vector<OutlinePiece> join(std::vector<OutlinePiece> pieces, double tolerance);

  /// Corner points and fillet radii, as FilletedCorners wants them. Arcs become corners whose fillets take all of
  /// their edges.
  struct OutlineCorners
  {
    std::vector<Point2> points;
    std::vector<double> radii;
    bool closed = false;
  };

  /// @param path joined @throws std::invalid_argument for pieces without length
  OutlineCorners corners_of(const std::vector<OutlinePiece> &path, double tolerance);
} // namespace deltaform
