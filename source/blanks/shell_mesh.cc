#include "shell_mesh.h"

#include <deltaform/geometry/grading.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/memory.h>

#include <numeric>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    /// Relative size of the elements. @throws std::invalid_argument where it cannot be used
    double relative_size(const TimeFunction &grading, const double t)
    {
      constexpr double most = 1e6;
      const double size = grading(t);
      if (!(size >= 1. / most && size <= most))
        throw std::invalid_argument("must lie between 1e-6 and 1e6 on [0, 1]; it is " + text::format(size) +
                                    " at t = " + text::format(t));
      return size;
    }

    /// In proportion to the number of elements between @p a and @p b, fractions of the whole meridian.
    double density(const TimeFunction &grading, const double a, const double b)
    {
      // The quadrature does not look at the ends.
      for (const double end : {a, b})
        relative_size(grading, end);
      if (grading.is_constant())
        return b - a;
      return element_density([&grading](const double t) { return relative_size(grading, t); }, a, b);
    }

    /// Share the elements among the pieces by their density, at least one each (largest remainder).
    std::vector<unsigned int> share(const std::vector<double> &weights, const unsigned int n_cells)
    {
      const double total = std::accumulate(weights.begin(), weights.end(), 0.);
      std::vector<unsigned int> result(weights.size(), 1);
      for (unsigned int given = weights.size(); given < n_cells; ++given)
      {
        unsigned int neediest = 0;
        double lack = -1;
        for (unsigned int i = 0; i < weights.size(); ++i)
          if (weights[i] / total * n_cells / result[i] > lack)
          {
            lack = weights[i] / total * n_cells / result[i];
            neediest = i;
          }
        ++result[neediest];
      }
      return result;
    }
  } // namespace


  ShellMesh::ShellMesh(Section &section, const unsigned int degree, const double element_bytes)
  {
    const auto rows =
      section.rows("Points",
                   required("0 0; 1 0"),
                   2,
                   "length",
                   "Corners 'r z; r z; ...' of the meridian of the mid-surface, from its start to its end. The "
                   "director points to the left of it: upwards for a flat blank that starts at the axis.");
    auto radii = section.numbers(
      "Fillet radii", "", "length", "Radius of the fillet at each corner (0: a kink); empty: no fillets.");
    const int n_cells = section.integer("Elements", 50, 1, 1000000, "Number of elements along the meridian.");
    const auto grading = section.function(
      "Grading",
      Default<std::string>("1"),
      "1",
      "Relative size of the elements as a function of t = arc length / length of the meridian; expression "
      "or table, for example '0: 1, 0.5: 0.2, 1: 1'.");

    if (rows.size() < 2)
      section.fail("Points", "a meridian needs at least two points");
    std::vector<Point2> points;
    for (const auto &row : rows)
      points.emplace_back(row[0], row[1]);
    if (radii.empty())
      radii.assign(points.size(), 0.);
    if (radii.size() != points.size())
      section.fail("Fillet radii",
                   "needs one radius per point: " + std::to_string(points.size()) + ", not " +
                     std::to_string(radii.size()));
    memory::require(section, "Elements", n_cells, "elements", element_bytes);
    try
    {
      pieces_ = build_meridian(points, radii);
    }
    catch (const std::invalid_argument &error)
    {
      section.fail("Points", error.what());
    }
    if (pieces_.size() > static_cast<unsigned int>(n_cells))
      section.fail("Elements",
                   "must be at least the number of straight and curved pieces, " + std::to_string(pieces_.size()));

    const double total = pieces_.back().arc_start + pieces_.back().length;
    std::vector<double> weights;
    try
    {
      for (const auto &piece : pieces_)
        weights.push_back(density(grading, piece.arc_start / total, (piece.arc_start + piece.length) / total));
      const auto shares = share(weights, n_cells);
      for (unsigned int i = 0; i < pieces_.size(); ++i)
        mesh_piece(i, shares[i], grading, total, degree);
    }
    catch (const std::invalid_argument &error)
    {
      section.fail("Grading", error.what());
    }
  }


  void ShellMesh::mesh_piece(const unsigned int number,
                             const unsigned int n_cells,
                             const TimeFunction &grading,
                             const double total_length,
                             const unsigned int degree)
  {
    const MeridianPiece &piece = pieces_[number];
    // Fractions of the piece.
    std::vector<double> ends(n_cells + 1, 1.);
    for (unsigned int c = 0; c < n_cells; ++c)
      ends[c] = static_cast<double>(c) / n_cells;
    if (!grading.is_constant())
      ends = element_ends(
        [&](const double fraction) {
          return relative_size(grading, (piece.arc_start + fraction * piece.length) / total_length);
        },
        0.,
        1.,
        n_cells);

    const auto at = [&](const double fraction) {
      const double s = fraction * piece.length;
      return Place{piece.point_at(s), piece.arc_start + s, piece.angle_at(s)};
    };
    if (nodes_.empty())
      add_node(at(0.));
    for (unsigned int c = 0; c < n_cells; ++c)
    {
      const double middle = .5 * (ends[c] + ends[c + 1]);
      Cell cell;
      cell.nodes[0] = nodes_.size() - 1;
      if (degree == 2)
        cell.nodes[2] = add_node(at(middle));
      cell.nodes[1] = add_node(at(ends[c + 1]));
      cell.angle = {{at(ends[c]).angle, at(ends[c + 1]).angle, at(middle).angle}};
      cell.piece = number;
      cells_.push_back(cell);
    }
  }


  unsigned int ShellMesh::add_node(const Place &place)
  {
    nodes_.push_back(place.point);
    arc_length_.push_back(place.arc_length);
    return nodes_.size() - 1;
  }


  ShellMesh::Place ShellMesh::place(const Cell &cell, const double share) const
  {
    const auto node = [&](const unsigned int a) {
      return Place{nodes_[cell.nodes[a]], arc_length_[cell.nodes[a]], cell.angle[a]};
    };
    if (share == 0. || share == 1.)
      return node(share == 0. ? 0 : 1);
    if (share == .5 && cell.nodes[2] != invalid_index)
      return node(2);
    const MeridianPiece &piece = pieces_[cell.piece];
    const double begin = arc_length_[cell.nodes[0]], end = arc_length_[cell.nodes[1]];
    const double arc_length = begin + share * (end - begin), s = arc_length - piece.arc_start;
    return {piece.point_at(s), arc_length, piece.angle_at(s)};
  }


  ShellMesh ShellMesh::divided(const std::vector<Part> &parts) const
  {
    ShellMesh result;
    result.pieces_ = pieces_;
    result.add_node(place(cells_.front(), 0.));
    for (const Part &part : parts)
    {
      const Cell &from = cells_[part.cell];
      const Place begin = place(from, part.begin), end = place(from, part.end);
      const Place middle = place(from, .5 * (part.begin + part.end));
      Cell cell;
      cell.nodes[0] = result.nodes_.size() - 1;
      if (from.nodes[2] != invalid_index)
        cell.nodes[2] = result.add_node(middle);
      cell.nodes[1] = result.add_node(end);
      cell.angle = part.whole() ? from.angle : std::array<double, 3>{{begin.angle, end.angle, middle.angle}};
      cell.piece = from.piece;
      result.cells_.push_back(cell);
    }
    return result;
  }
} // namespace deltaform
