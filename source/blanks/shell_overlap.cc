#include "shell_overlap.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Distance of @p x from the line between @p a and @p b.
    double distance(const Point2 &x, const Point2 &a, const Point2 &b)
    {
      const Tensor1 way = b - a;
      const double share = std::clamp((x - a) * way / way.norm_square(), 0., 1.);
      return x.distance(a + share * way);
    }
  } // namespace


  Overlap find_overlap(const ShellSpace &space, const ShellSurface &surface, const ShellState &state, const Vector &q)
  {
    constexpr double opposite = 150. * dealii::numbers::PI / 180.;
    std::vector<double> angle(space.n_nodes());
    for (unsigned int i = 0; i < angle.size(); ++i)
      angle[i] = surface.director_angle(q, i);
    const auto [least, most] = std::minmax_element(angle.begin(), angle.end());
    if (*most - *least < opposite)
      return {};

    Overlap result;
    for (unsigned int i = 0; i < angle.size(); ++i)
    {
      const Point2 here = space.position(q, i);
      for (const auto &cell : space.mesh().cells())
      {
        const unsigned int a = cell.nodes[0], b = cell.nodes[1];
        if (std::min(std::abs(angle[i] - angle[a]), std::abs(angle[i] - angle[b])) < opposite)
          continue;
        const double thickness =
          .5 * state.face_thickness(i) + .25 * (state.face_thickness(a) + state.face_thickness(b));
        const double share = 1. - distance(here, space.position(q, a), space.position(q, b)) / thickness;
        if (share > result.share)
          result = {share, space.mesh().nodes()[i][0], space.mesh().nodes()[a][0]};
      }
    }
    return result;
  }
} // namespace deltaform
