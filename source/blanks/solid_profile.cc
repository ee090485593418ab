#include "solid_profile.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace deltaform
{
  SolidProfile::SolidProfile(const SolidDiscretization &body,
                             const SolidSurface &surface,
                             const MaterialPoints &material,
                             const Vector &q)
    : space_(body.space()), surface_(surface), q_(q), criteria_(material.criteria())
  {
    const SolidPoints &points = body.points();
    const unsigned int n = points.size();
    plastic_.resize(n);
    for (auto &component : stress_)
      component.resize(n);
    for (unsigned int p = 0; p < n; ++p)
    {
      plastic_[p] = material.equivalent_plastic_strain(p);
      for (unsigned int k = 0; k < 4; ++k)
        stress_[k][p] = material.committed_stress(p)[k] * (k == 3 ? std::sqrt(.5) : 1.);
    }
    plastic_ = points.to_nodes(plastic_);
    for (auto &component : stress_)
      component = points.to_nodes(component);
    for (unsigned int k = 0; k < criteria_.n_fields(); ++k)
    {
      std::vector<double> values(n);
      for (unsigned int p = 0; p < n; ++p)
        values[p] = criteria_.value(p, k);
      criteria_values_.push_back(points.to_nodes(values));
    }
    collect_groups();
  }


  void SolidProfile::collect_groups()
  {
    if (!space_.mesh().is_strip())
    {
      for (const unsigned int side : {0, 1})
        for (const auto node : surface_.face(side).nodes())
          groups_.push_back({node});
      return;
    }
    std::map<long, Group> cross_sections;
    for (unsigned int i = 0; i < space_.nodes().size(); ++i)
      cross_sections[space_.cross_section(i)].push_back(i);
    for (auto &[place, nodes] : cross_sections)
    {
      std::sort(nodes.begin(),
                nodes.end(),
                [&](const unsigned int a, const unsigned int b) {
                  return space_.parameter(a)[1] < space_.parameter(b)[1];
                });
      // Only columns that go through from bottom to top.
      if (space_.parameter(nodes.front())[1] < -.5 + 1e-9 && space_.parameter(nodes.back())[1] > .5 - 1e-9)
        groups_.push_back(nodes);
    }
  }


  Point2 SolidProfile::middle(const Group &nodes, const bool deformed) const
  {
    const auto at = [&](const unsigned int i) { return deformed ? space_.position(q_, i) : space_.nodes()[i]; };
    return at(nodes.front()) + .5 * (at(nodes.back()) - at(nodes.front()));
  }


  Tensor1 SolidProfile::along(const unsigned int group, const bool deformed) const
  {
    const Group &before = groups_[group == 0 ? 0 : group - 1];
    const Group &after = groups_[std::min<std::size_t>(group + 1, groups_.size() - 1)];
    return middle(after, deformed) - middle(before, deformed);
  }


  double SolidProfile::hoop_strain(const unsigned int group) const
  {
    if (!space_.axisymmetric())
      return 0.;
    const double R = middle(groups_[group], false)[0], r = middle(groups_[group], true)[0];
    if (R > 1e-9 * space_.mesh().thickness())
      return std::log(r / R);
    const Group &after = groups_[std::min<std::size_t>(group + 1, groups_.size() - 1)];
    return std::log(middle(after, true)[0] / middle(after, false)[0]);
  }


  double SolidProfile::thickness(const unsigned int group) const
  {
    const Group &nodes = groups_[group];
    const double across =
      space_.mesh().is_strip()
        ? space_.position(q_, nodes.back()).distance(space_.position(q_, nodes.front()))
        : surface_.face(group < surface_.face(0).nodes().size() ? 1 : 0).distance(q_, middle(nodes, true));
    return std::isfinite(across) ? across : space_.mesh().thickness();
  }


  double SolidProfile::thickness_strain(const unsigned int group) const
  {
    const Group &nodes = groups_[group];
    const double now = thickness(group);
    const double before =
      space_.mesh().is_strip() ? space_.nodes()[nodes.back()].distance(space_.nodes()[nodes.front()]) : now;
    return std::log(now / before);
  }


  double SolidProfile::mean(const std::vector<double> &values, const Group &nodes) const
  {
    double sum = 0., share = 0.;
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      const double w = nodes.size() == 1
                         ? 1.
                         : .5 * (space_.parameter(nodes[std::min(k + 1, nodes.size() - 1)])[1] -
                                 space_.parameter(nodes[k == 0 ? 0 : k - 1])[1]);
      sum += w * values[nodes[k]];
      share += w;
    }
    return sum / share;
  }


  std::vector<double> SolidProfile::row(const unsigned int group, const double arc) const
  {
    const Group &nodes = groups_[group];
    const unsigned int bottom = nodes.front(), top = nodes.back();
    const Point2 X = middle(nodes, false), x = middle(nodes, true);
    const Tensor1 tangent = along(group, true), t = tangent / tangent.norm();
    const auto meridional = [&](const unsigned int i) {
      return t[0] * t[0] * stress_[0][i] + t[1] * t[1] * stress_[1][i] + 2 * t[0] * t[1] * stress_[3][i];
    };
    const auto displacement = [&](const unsigned int i, const unsigned int k) { return q_[space_.dofs()[i][k]]; };
    return {X[0],
            x[0],
            x[1],
            thickness(group),
            std::log(tangent.norm() / along(group, false).norm()),
            hoop_strain(group),
            thickness_strain(group),
            mean(plastic_, nodes),
            meridional(bottom),
            meridional(top),
            stress_[2][bottom],
            stress_[2][top],
            arc,
            x[0] - X[0],
            x[1] - X[1],
            X[1],
            mean(stress_[0], nodes),
            mean(stress_[1], nodes),
            mean(stress_[2], nodes),
            mean(stress_[3], nodes),
            displacement(bottom, 0),
            displacement(bottom, 1),
            displacement(top, 0),
            displacement(top, 1)};
  }


  Table SolidProfile::table() const
  {
    Table table;
    for (const auto &[name, unit] : std::vector<std::pair<const char *, const char *>>{
           {"R0", "length"},
           {"r", "length"},
           {"z", "length"},
           {"thickness", "length"},
           {"eps_meridional", "1"},
           {"eps_hoop", "1"},
           {"eps_thickness", "1"},
           {"equivalent_plastic_strain", "1"},
           {"stress_meridional_bottom", "stress"},
           {"stress_meridional_top", "stress"},
           {"stress_hoop_bottom", "stress"},
           {"stress_hoop_top", "stress"},
           {"S0", "length"},
           {"u_r", "length"},
           {"u_z", "length"},
           {"Z0", "length"},
           {"stress_rr", "stress"},
           {"stress_zz", "stress"},
           {"stress_hoop", "stress"},
           {"stress_rz", "stress"},
           {"u_r_bottom", "length"},
           {"u_z_bottom", "length"},
           {"u_r_top", "length"},
           {"u_z_top", "length"}})
    {
      table.names.emplace_back(name);
      table.units.emplace_back(unit);
    }
    for (unsigned int k = 0; k < criteria_.n_fields(); ++k)
    {
      table.names.push_back(criteria_.column(k));
      table.units.push_back(criteria_.field(k).unit());
    }
    double arc = 0.;
    for (unsigned int g = 0; g < groups_.size(); ++g)
    {
      if (g > 0)
        arc += middle(groups_[g], false).distance(middle(groups_[g - 1], false));
      table.rows.push_back(row(g, arc));
      for (const auto &values : criteria_values_)
        table.rows.back().push_back(mean(values, groups_[g]));
    }
    return table;
  }
} // namespace deltaform
