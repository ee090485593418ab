#include <deltaform/scene/contact_edge.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  double shortest_contact_edge(const Blank &blank)
  {
    double shortest = std::numeric_limits<double>::infinity();
    if (!blank.fields().is_sheet())
      shortest = blank.typical_length();
    else
    {
      const auto nodes = blank.positions(Vector(blank.n_dofs()));
      for (const auto &[a, b, middle] : blank.surface().contact_edges(Side::top))
        shortest = middle == invalid_index ? std::min(shortest, nodes[a].distance(nodes[b]))
                                           : std::min({shortest,
                                                       nodes[a].distance(nodes[middle]),
                                                       nodes[middle].distance(nodes[b])});
    }
    return std::isfinite(shortest) && shortest > 0. ? shortest : blank.initial_thickness();
  }
} // namespace deltaform
