#include "outline_path.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    /// Of the last digits: fillets that take all of their edges must not take more.
    constexpr double spared = 2e-13;

    double angle_of(const Point2 &from, const Point2 &to)
    {
      return std::atan2(to[1] - from[1], to[0] - from[0]);
    }

    /// In (-pi, pi].
    double turn(const double from, const double to)
    {
      return std::remainder(to - from, 2. * dealii::numbers::PI);
    }

    /// Half the angle of an arc, by which its tangents differ from its chord.
    double half_angle(const OutlinePiece &piece)
    {
      return 2. * std::atan(piece.bulge);
    }

    double angle_at_start(const OutlinePiece &piece)
    {
      return angle_of(piece.start, piece.end) - half_angle(piece);
    }

    std::string in_words(const Point2 &x)
    {
      std::ostringstream text;
      text << "(" << x[0] << " " << x[1] << ")";
      return text.str();
    }

    /// The corners of an arc between its ends: as many as keep each below a quarter of a circle.
    void add_arc(const OutlinePiece &piece, OutlineCorners &corners)
    {
      const double sweep = 2. * half_angle(piece);
      const double radius = piece.start.distance(piece.end) / (2. * std::abs(std::sin(.5 * sweep)));
      const double to_center = angle_at_start(piece) + std::copysign(.5 * dealii::numbers::PI, sweep);
      const Point2 center = piece.start + radius * Tensor1({std::cos(to_center), std::sin(to_center)});
      const auto n = static_cast<unsigned int>(std::ceil(std::abs(sweep) / (.4 * dealii::numbers::PI)));
      const double part = sweep / n, out = radius / std::cos(.5 * part);
      const double first = angle_of(center, piece.start);
      for (unsigned int i = 0; i < n; ++i)
      {
        const double angle = first + (i + .5) * part;
        corners.points.push_back(center + out * Tensor1({std::cos(angle), std::sin(angle)}));
        corners.radii.push_back(radius * (1. - spared));
      }
    }
  } // namespace


  OutlinePiece arc_about(const Point2 &center, const Point2 &start, const Point2 &end, const bool counterclockwise)
  {
    double sweep = turn(angle_of(center, start), angle_of(center, end));
    if (counterclockwise && sweep <= 0.)
      sweep += 2. * dealii::numbers::PI;
    if (!counterclockwise && sweep >= 0.)
      sweep -= 2. * dealii::numbers::PI;
    return {start, end, std::tan(.25 * sweep)};
  }


  std::vector<OutlinePiece> join(std::vector<OutlinePiece> pieces, const double tolerance)
  {
    if (pieces.empty())
      throw std::invalid_argument("the outline has no lines or arcs");
    std::vector<OutlinePiece> path{pieces.front()};
    pieces.erase(pieces.begin());
    const auto meet = [&](const Point2 &a, const Point2 &b) { return a.distance(b) <= tolerance; };
    for (bool found = true; found && !pieces.empty();)
    {
      found = false;
      for (auto piece = pieces.begin(); piece != pieces.end() && !found; ++piece)
      {
        const Point2 first = path.front().start, last = path.back().end;
        found = true;
        if (meet(piece->start, last))
          path.push_back(*piece);
        else if (meet(piece->end, last))
          path.push_back(piece->reversed());
        else if (meet(piece->end, first))
          path.insert(path.begin(), *piece);
        else if (meet(piece->start, first))
          path.insert(path.begin(), piece->reversed());
        else
          found = false;
        if (found)
        {
          pieces.erase(piece);
          break;
        }
      }
    }
    if (!pieces.empty())
      throw std::invalid_argument("the outline is no single path: the piece that starts at " +
                                  in_words(pieces.front().start) + " meets none of the path from " +
                                  in_words(path.front().start) + " to " + in_words(path.back().end));
    return path;
  }


  OutlineCorners corners_of(const std::vector<OutlinePiece> &path, const double tolerance)
  {
    OutlineCorners corners;
    corners.closed = path.size() > 1 && path.front().start.distance(path.back().end) <= tolerance;
    for (const OutlinePiece &piece : path)
    {
      if (!(piece.start.distance(piece.end) > tolerance))
        throw std::invalid_argument("the outline has a piece without length at " + in_words(piece.start));
      // Where it is smooth, the joint is no corner of the curve.
      corners.points.push_back(piece.start);
      corners.radii.push_back(0.);
      if (piece.bulge != 0.)
        add_arc(piece, corners);
    }
    if (!corners.closed)
    {
      corners.points.push_back(path.back().end);
      corners.radii.push_back(0.);
    }
    return corners;
  }
} // namespace deltaform
