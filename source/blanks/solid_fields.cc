// Table of the accepted state of the solid.
#include "solid.h"

#include <algorithm>
#include <cmath>

namespace deltaform
{
  std::vector<double> Solid::flow_stress(const Side side) const
  {
    std::vector<double> values(points_.size());
    for (unsigned int p = 0; p < values.size(); ++p)
      values[p] = material_.flow_stress(p);
    values = points_.to_nodes(values);
    std::vector<double> result;
    for (const auto node : faces_[static_cast<unsigned int>(side)].nodes())
      result.push_back(values[node]);
    return result;
  }


  Table Solid::profile(const Vector &state) const
  {
    Vector storage;
    const Vector &q = space_.hanging().with_hanging(state, storage);
    Table table;
    table.names = {"R0",
                   "r",
                   "z",
                   "thickness",
                   "eps_meridional",
                   "eps_hoop",
                   "eps_thickness",
                   "equivalent_plastic_strain",
                   "stress_meridional_bottom",
                   "stress_meridional_top",
                   "stress_hoop_bottom",
                   "stress_hoop_top",
                   "S0",
                   "u_r",
                   "u_z",
                   "Z0",
                   "stress_rr",
                   "stress_zz",
                   "stress_hoop",
                   "stress_rz",
                   "u_r_bottom",
                   "u_z_bottom",
                   "u_r_top",
                   "u_z_top"};
    table.units = {"length", "length", "length", "length", "1", "1", "1", "1",
                   "stress", "stress", "stress", "stress", "length", "length", "length", "length",
                   "stress", "stress", "stress", "stress", "length", "length", "length", "length"};

    const unsigned int n = points_.size();
    std::vector<double> plastic(n);
    std::array<std::vector<double>, 4> stress;
    for (auto &component : stress)
      component.resize(n);
    for (unsigned int p = 0; p < n; ++p)
    {
      plastic[p] = material_.equivalent_plastic_strain(p);
      for (unsigned int k = 0; k < 4; ++k)
        stress[k][p] = material_.committed_stress(p)[k] * (k == 3 ? std::sqrt(.5) : 1.);
    }
    plastic = points_.to_nodes(plastic);
    for (auto &component : stress)
      component = points_.to_nodes(component);

    // A strip: its middle line. Another body: the nodes that tools can touch, bottom first.
    std::vector<std::vector<unsigned int>> groups;
    std::vector<double> arc;
    if (space_.mesh().is_strip())
    {
      std::map<long, std::vector<unsigned int>> stations;
      for (unsigned int i = 0; i < space_.nodes().size(); ++i)
        stations[space_.station(i)].push_back(i);
      for (auto &[place, nodes] : stations)
      {
        std::sort(nodes.begin(),
                  nodes.end(),
                  [&](const unsigned int a, const unsigned int b) {
                    return space_.parameter(a)[1] < space_.parameter(b)[1];
                  });
        // Only columns that go through from bottom to top.
        if (space_.parameter(nodes.front())[1] < -.5 + 1e-9 && space_.parameter(nodes.back())[1] > .5 - 1e-9)
          groups.push_back(nodes);
      }
    }
    else
      for (const auto &face : faces_)
        for (const auto node : face.nodes())
          groups.push_back({node});

    const auto middle = [&](const std::vector<unsigned int> &nodes, const bool deformed) -> Point2 {
      const auto at = [&](const unsigned int i) { return deformed ? space_.position(q, i) : space_.nodes()[i]; };
      return at(nodes.front()) + .5 * (at(nodes.back()) - at(nodes.front()));
    };
    for (unsigned int g = 0; g < groups.size(); ++g)
    {
      const auto &nodes = groups[g];
      const Point2 X = middle(nodes, false), x = middle(nodes, true);
      arc.push_back(g == 0 ? 0. : arc.back() + X.distance(middle(groups[g - 1], false)));
      // Of the middle line, by the neighbours.
      const auto &before = groups[g == 0 ? 0 : g - 1], &after = groups[std::min<std::size_t>(g + 1, groups.size() - 1)];
      const Tensor1 tangent = middle(after, true) - middle(before, true);
      const double stretch = tangent.norm() / middle(after, false).distance(middle(before, false));
      const bool strip = space_.mesh().is_strip();
      // Infinite where tools touch one face only: there is no thickness but the entry.
      const double across = strip ? space_.position(q, nodes.back()).distance(space_.position(q, nodes.front()))
                                  : faces_[g < faces_[0].nodes().size() ? 1 : 0].distance(q, x);
      const double thickness = std::isfinite(across) ? across : space_.mesh().thickness();
      const double thickness_0 =
        strip ? space_.nodes()[nodes.back()].distance(space_.nodes()[nodes.front()]) : thickness;
      const double hoop = !space_.axisymmetric() ? 0.
                          : X[0] > 1e-9 * space_.mesh().thickness()
                            ? std::log(x[0] / X[0])
                            : std::log(middle(after, true)[0] / middle(after, false)[0]);
      double plastic_mean = 0, share = 0;
      std::array<double, 4> mean{};
      for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const double w = nodes.size() == 1
                           ? 1.
                           : .5 * (space_.parameter(nodes[std::min<std::size_t>(k + 1, nodes.size() - 1)])[1] -
                                   space_.parameter(nodes[k == 0 ? 0 : k - 1])[1]);
        plastic_mean += w * plastic[nodes[k]];
        for (unsigned int s = 0; s < 4; ++s)
          mean[s] += w * stress[s][nodes[k]];
        share += w;
      }
      const auto displacement = [&](const unsigned int i, const unsigned int k) { return q[space_.dofs()[i][k]]; };
      const auto meridional = [&](const unsigned int i) {
        const Tensor1 t = tangent / tangent.norm();
        return t[0] * t[0] * stress[0][i] + t[1] * t[1] * stress[1][i] + 2 * t[0] * t[1] * stress[3][i];
      };
      table.rows.push_back({X[0],
                            x[0],
                            x[1],
                            thickness,
                            std::log(stretch),
                            hoop,
                            std::log(thickness / thickness_0),
                            plastic_mean / share,
                            meridional(nodes.front()),
                            meridional(nodes.back()),
                            stress[2][nodes.front()],
                            stress[2][nodes.back()],
                            arc.back(),
                            x[0] - X[0],
                            x[1] - X[1],
                            X[1],
                            mean[0] / share,
                            mean[1] / share,
                            mean[2] / share,
                            mean[3] / share,
                            displacement(nodes.front(), 0),
                            displacement(nodes.front(), 1),
                            displacement(nodes.back(), 0),
                            displacement(nodes.back(), 1)});
    }
    return table;
  }
} // namespace deltaform
