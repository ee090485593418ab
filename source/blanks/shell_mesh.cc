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
    std::vector<MeridianPiece> pieces;
    try
    {
      pieces = build_meridian(points, radii);
    }
    catch (const std::invalid_argument &error)
    {
      section.fail("Points", error.what());
    }
    if (pieces.size() > static_cast<unsigned int>(n_cells))
      section.fail("Elements",
                   "must be at least the number of straight and curved pieces, " + std::to_string(pieces.size()));

    const double total = pieces.back().arc_start + pieces.back().length;
    std::vector<double> weights;
    try
    {
      for (const auto &piece : pieces)
        weights.push_back(density(grading, piece.arc_start / total, (piece.arc_start + piece.length) / total));
      const auto shares = share(weights, n_cells);
      for (unsigned int i = 0; i < pieces.size(); ++i)
        mesh_piece(pieces[i], shares[i], grading, total, degree);
    }
    catch (const std::invalid_argument &error)
    {
      section.fail("Grading", error.what());
    }
  }


  void ShellMesh::mesh_piece(const MeridianPiece &piece,
                             const unsigned int n_cells,
                             const TimeFunction &grading,
                             const double total_length,
                             const unsigned int degree)
  {
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

    const auto add_node = [&](const double fraction) {
      nodes_.push_back(piece.point_at(fraction * piece.length));
      arc_length_.push_back(piece.arc_start + fraction * piece.length);
      return static_cast<unsigned int>(nodes_.size() - 1);
    };
    if (nodes_.empty())
      add_node(0.);
    for (unsigned int c = 0; c < n_cells; ++c)
    {
      const double middle = .5 * (ends[c] + ends[c + 1]);
      Cell cell;
      cell.nodes[0] = nodes_.size() - 1;
      if (degree == 2)
        cell.nodes[2] = add_node(middle);
      cell.nodes[1] = add_node(ends[c + 1]);
      cell.angle = {{piece.angle_at(ends[c] * piece.length),
                     piece.angle_at(ends[c + 1] * piece.length),
                     piece.angle_at(middle * piece.length)}};
      cells_.push_back(cell);
    }
  }
} // namespace deltaform
