#include <deltaform/kinematics/meridian.h>

#include <cmath>
#include <stdexcept>
#include <string>

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
    const unsigned int n = points.size();
    if (n < 2 || radii.size() != n)
      throw std::invalid_argument("a meridian needs at least two points and one fillet radius per point");

    std::vector<Tensor1> tangent;
    std::vector<double> length;
    for (unsigned int i = 0; i + 1 < n; ++i)
    {
      const Tensor1 edge = points[i + 1] - points[i];
      length.push_back(edge.norm());
      if (!(length.back() > 0))
        throw std::invalid_argument("points " + std::to_string(i + 1) + " and " + std::to_string(i + 2) + " coincide");
      tangent.push_back(edge / length.back());
    }

    // Turn at each corner, and what its fillet takes of both edges: R tan(|turn| / 2).
    std::vector<double> turn(n, 0.), setback(n, 0.);
    for (unsigned int i = 1; i + 1 < n; ++i)
    {
      turn[i] =
        std::atan2(tangent[i - 1][0] * tangent[i][1] - tangent[i - 1][1] * tangent[i][0], tangent[i - 1] * tangent[i]);
      setback[i] = radii[i] * std::tan(.5 * std::abs(turn[i]));
    }

    std::vector<MeridianPiece> pieces;
    double arc = 0;
    const auto append = [&](MeridianPiece piece) {
      piece.arc_start = arc;
      arc += piece.length;
      pieces.push_back(piece);
    };
    for (unsigned int i = 0; i + 1 < n; ++i)
    {
      const double straight = length[i] - setback[i] - setback[i + 1];
      const double angle = std::atan2(tangent[i][1], tangent[i][0]);
      if (straight < -1e-12 * length[i])
        throw std::invalid_argument("the fillets at points " + std::to_string(i + 1) + " and " + std::to_string(i + 2) +
                                    " do not fit between them");
      if (straight > 1e-12 * length[i])
        append({points[i] + setback[i] * tangent[i], angle, 0., straight, 0.});
      if (setback[i + 1] > 0)
        append({points[i + 1] - setback[i + 1] * tangent[i],
                angle,
                (turn[i + 1] > 0 ? 1. : -1.) / radii[i + 1],
                radii[i + 1] * std::abs(turn[i + 1]),
                0.});
    }
    return pieces;
  }
} // namespace deltaform
