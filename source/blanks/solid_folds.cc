#include "solid_folds.h"

#include <deltaform/process/ranks.h>

#include <algorithm>
#include <array>

namespace deltaform
{
  namespace
  {
    using Corners = std::array<Point2, 9>; ///< corners, middles of the edges, centre

    double cross(const Tensor1 &a, const Tensor1 &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    /// dx/dxi at the end @p here of an edge to @p other, away from it; @p middle: of an edge of degree 2.
    Tensor1 slope(const Corners &x, const unsigned int here, const unsigned int other, const unsigned int middle,
                  const unsigned int degree)
    {
      return degree == 1 ? x[other] - x[here] : 4. * (x[middle] - x[here]) - (x[other] - x[here]);
    }

    bool is_folded(const Corners &x, const unsigned int degree)
    {
      for (unsigned int v = 0; v < 4; ++v)
      {
        const bool right = v % 2 == 1, upper = v / 2 == 1;
        const Tensor1 along = slope(x, v, v ^ 1u, upper ? 7 : 6, degree);
        const Tensor1 across = slope(x, v, v ^ 2u, right ? 5 : 4, degree);
        if ((right != upper ? -1. : 1.) * cross(along, across) <= 0.)
          return true;
      }
      return false;
    }

    /// Of the quadrilateral between the corners.
    double area(const Corners &x)
    {
      return .5 * std::abs(cross(x[3] - x[0], x[2] - x[1]));
    }

    /// Area of a folded cell, and where its middle was.
    struct Fold
    {
      double area, r, z;
    };

    /// Of equal areas that of the least place, so that the number of processes does not matter.
    bool is_less(const Fold &a, const Fold &b)
    {
      return std::array<double, 3>{{a.area, b.r, b.z}} < std::array<double, 3>{{b.area, a.r, a.z}};
    }
  } // namespace


  FoldedCells find_folded_cells(const SolidSpace &space, const Vector &q)
  {
    std::array<double, 2> areas{{0., 0.}}; // of folded cells, of all
    Fold largest{0., 0., 0.};
    for (const auto &nodes : space.cells())
    {
      Corners x;
      for (unsigned int a = 0; a < space.n_nodes_per_cell(); ++a)
        x[a] = space.position(q, nodes[a]);
      const double size = area(x);
      areas[1] += size;
      if (!is_folded(x, space.degree()))
        continue;
      areas[0] += size;
      const Point2 middle = space.nodes()[nodes[0]] + .5 * (space.nodes()[nodes[3]] - space.nodes()[nodes[0]]);
      const Fold fold{size, middle[0], middle[1]};
      if (is_less(largest, fold))
        largest = fold;
    }
    ranks::sum(areas.data(), areas.size());
    if (areas[0] == 0.)
      return {};
    const auto all = ranks::gather(std::vector<Fold>{largest});
    const Fold worst = *std::max_element(all.begin(), all.end(), is_less);
    return {areas[0] / areas[1], Point2(worst.r, worst.z)};
  }
} // namespace deltaform
