#include <deltaform/geometry/fillets.h>
#include <deltaform/geometry/meridian.h>

#include <cmath>

namespace deltaform
{
  Point2 MeridianPiece::point_at(const double s) const
  {
    if (curvature == 0)
      return start + s * Tensor1({std::cos(angle), std::sin(angle)});
    const double end = angle_at(s);
    return start + Tensor1({std::sin(end) - std::sin(angle), std::cos(angle) - std::cos(end)}) / curvature;
  }


  std::vector<MeridianPiece> build_meridian(const std::vector<Point2> &points, const std::vector<double> &radii)
  {
    const FilletedCorners corners(points, radii, false);
    std::vector<MeridianPiece> pieces;
    double arc = 0;
    const auto append = [&](MeridianPiece piece) {
      piece.arc_start = arc;
      arc += piece.length;
      pieces.push_back(piece);
    };
    for (unsigned int i = 0; i < corners.n_edges(); ++i)
    {
      const Tensor1 &tangent = corners.tangent(i);
      const double angle = std::atan2(tangent[1], tangent[0]);
      if (const double straight = corners.straight(i); straight > 0.)
        append({points[i] + corners.setback(i) * tangent, angle, 0., straight, 0.});
      if (!corners.is_corner(i + 1) || corners.setback(i + 1) == 0.)
        continue;
      const Tensor1 &after = corners.tangent(i + 1);
      const double turn = std::atan2(tangent[0] * after[1] - tangent[1] * after[0], tangent * after);
      append({points[i + 1] - corners.setback(i + 1) * tangent,
              angle,
              (turn > 0 ? 1. : -1.) / radii[i + 1],
              radii[i + 1] * std::abs(turn),
              0.});
    }
    return pieces;
  }
} // namespace deltaform
