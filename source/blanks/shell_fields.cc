// Tables of the accepted state of the shell.
#include "shell_fields.h"
#include "shell_overlap.h"
#include "shell_sections.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace deltaform
{
  namespace
  {
    /// Columns of the profile that are averages of all scenes.
    constexpr std::size_t n_averages = 11;

    /// From the second to this one they are continued to a free edge: strains, equivalent plastic strain. The thickness
    /// follows from its strain; stresses, which change with the elastic core, stay those of the points.
    constexpr std::size_t last_at_edges = 4;
  } // namespace


  Table ShellFields::profile(const Vector &q) const
  {
    Table table;
    for (const auto &[name, unit] : std::vector<std::pair<const char *, const char *>>{
           {"R0", "length"},
           {"r", "length"},
           {"z", "length"},
           {"rotation", "rad"},
           {"thickness", "length"},
           {"eps_meridional", "1"},
           {"eps_hoop", "1"},
           {"eps_thickness", "1"},
           {"equivalent_plastic_strain", "1"},
           {"stress_meridional_bottom", "stress"},
           {"stress_meridional_mid", "stress"},
           {"stress_meridional_top", "stress"},
           {"stress_hoop_bottom", "stress"},
           {"stress_hoop_mid", "stress"},
           {"stress_hoop_top", "stress"},
           {"S0", "length"},
           {"u_r", "length"},
           {"u_z", "length"}})
    {
      table.names.emplace_back(name);
      table.units.emplace_back(unit);
    }
    const PointCriteria &criteria = material_.criteria();
    for (unsigned int k = 0; k < criteria.n_fields(); ++k)
    {
      table.names.push_back(criteria.column(k));
      table.units.push_back(criteria.field(k).unit());
    }
    const auto values = averages();
    for (unsigned int i = 0; i < space_.n_nodes(); ++i)
    {
      const Point2 x = space_.position(q, i);
      std::vector<double> row{space_.mesh().nodes()[i][0], x[0], x[1], space_.rotation(q, i)};
      for (std::size_t k = 0; k < n_averages; ++k)
        row.push_back(values[k][i]);
      row.push_back(space_.mesh().arc_length()[i]);
      // Displacements on their own: coordinates do not print enough digits of small ones.
      row.push_back(q[space_.dofs()[i][0]]);
      row.push_back(q[space_.dofs()[i][1]]);
      for (std::size_t k = n_averages; k < values.size(); ++k)
        row.push_back(values[k][i]);
      table.rows.push_back(row);
    }
    return table;
  }


  std::vector<std::vector<double>> ShellFields::averages() const
  {
    // thickness, three strains, equivalent plastic strain, and two stresses at bottom, middle and top
    const unsigned int n = points_.size(), n_layers = points_.n_layers();
    const unsigned int n_criteria = material_.criteria().n_fields();
    std::vector<std::vector<double>> values(n_averages + n_criteria, std::vector<double>(n, 0.));
    for (unsigned int p = 0; p < n; ++p)
    {
      const auto layer = [&](const unsigned int l) { return p * n_layers + l; };
      for (unsigned int l = 0; l < n_layers; ++l)
      {
        const double w = points_.layer_weight(l) / points_.thickness();
        values[1][p] += w * state_.strain(layer(l))[0];
        values[2][p] += w * state_.strain(layer(l))[1];
        values[4][p] += w * material_.equivalent_plastic_strain(layer(l));
      }
      values[0][p] = points_.thickness() * state_.thickness_ratio(p);
      values[3][p] = std::log(state_.thickness_ratio(p));
      for (unsigned int k = 0; k < 2; ++k)
      {
        values[5 + 3 * k][p] = material_.committed_stress(layer(0))[k];
        values[6 + 3 * k][p] = material_.committed_stress(layer(n_layers / 2))[k];
        values[7 + 3 * k][p] = material_.committed_stress(layer(n_layers - 1))[k];
      }
      for (unsigned int k = 0; k < n_criteria; ++k)
        values[n_averages + k][p] = criterion(p, k);
    }
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      const std::vector<double> at_points = values[k];
      values[k] = points_.to_nodes(at_points);
      if (k > 0 && k <= last_at_edges)
        points_.to_edges(at_points, values[k]);
    }
    const auto &cells = space_.mesh().cells();
    for (const unsigned int edge : {cells.front().nodes[0], cells.back().nodes[1]})
      values[0][edge] = points_.thickness() * std::exp(values[3][edge]);
    for (double &plastic : values[4])
      plastic = std::max(plastic, 0.);
    return values;
  }


  double ShellFields::criterion(const unsigned int point, const unsigned int k) const
  {
    const std::size_t first = static_cast<std::size_t>(point) * points_.n_layers();
    return material_.criteria().across(first, points_.layer_shares(), k);
  }


  std::vector<LargestCriterion> ShellFields::largest_criteria() const
  {
    const PointCriteria &criteria = material_.criteria();
    std::vector<LargestCriterion> result;
    for (unsigned int k = 0; k < criteria.n_fields(); ++k)
    {
      LargestCriterion largest{criteria.names()[k], criteria.column(k), criteria.field(k).unit(), 0., Point2()};
      unsigned int place = 0;
      for (unsigned int p = 0; p < points_.size(); ++p)
        if (const double value = criterion(p, k); p == 0 || value > largest.value)
        {
          largest.value = value;
          place = p;
        }
      const auto &nodes = space_.mesh().cells()[place / points_.per_cell()].nodes;
      for (unsigned int a = 0; a <= space_.degree(); ++a)
        largest.place += points_[place].shape[a] * space_.mesh().nodes()[nodes[a]];
      result.push_back(largest);
    }
    return result;
  }


  double ShellFields::smallest_thickness() const
  {
    return state_.smallest_thickness();
  }


  bool ShellFields::is_sheet() const
  {
    return true;
  }


  SharpestBend ShellFields::sharpest_bend(const Vector &q) const
  {
    SharpestBend result;
    const auto &nodes = space_.mesh().nodes();
    const auto &cells = space_.mesh().cells();
    for (unsigned int c = 0; c < cells.size(); ++c)
      if (const double angle = std::abs(space_.bend(q, c)); angle > result.angle)
      {
        const unsigned int a = cells[c].nodes[0], b = cells[c].nodes[1];
        const auto &s = space_.mesh().arc_length();
        result = {angle, .5 * (nodes[a][0] + nodes[b][0]), (s[b] - s[a]) / points_.thickness()};
      }
    return result;
  }


  double ShellFields::flow_stress(const unsigned int point) const
  {
    double result = 0.;
    for (unsigned int l = 0; l < points_.n_layers(); ++l)
      result += points_.layer_weight(l) * material_.flow_stress(point * points_.n_layers() + l);
    return result / points_.thickness();
  }


  LargestShear ShellFields::largest_shear(const Vector &q) const
  {
    LargestShear result;
    const double stiffness = kernel_.shear_stiffness() / points_.thickness();
    if (!(stiffness > 0.) || !material_.plastic())
      return result;
    const double initial = material_.initial_flow_stress();
    const auto &nodes = space_.mesh().nodes();
    const auto &cells = space_.mesh().cells();
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int p = c * points_.per_cell(); p < (c + 1) * points_.per_cell(); ++p)
      {
        const double stress = stiffness * std::abs(points_.strain(q, c, p).gamma - points_[p].gamma);
        // Metals harden: few points have to be asked for their flow stress.
        if (stress <= result.share * initial)
          continue;
        if (const double share = stress / flow_stress(p); share > result.share)
          result = {share, .5 * (nodes[cells[c].nodes[0]][0] + nodes[cells[c].nodes[1]][0])};
      }
    return result;
  }


  InnermostPlace ShellFields::innermost_place(const Vector &q) const
  {
    InnermostPlace result;
    const auto &nodes = space_.mesh().nodes();
    for (unsigned int i = 0; i < nodes.size(); ++i)
    {
      const double thickness = state_.face_thickness(i);
      if (nodes[i][0] <= thickness)
        continue;
      const double r = space_.position(q, i)[0] - .5 * thickness * std::abs(std::sin(surface_.director_angle(q, i)));
      if (r < result.r)
        result = {r, i, nodes[i][0]};
    }
    return result;
  }


  Overlap ShellFields::overlap(const Vector &q) const
  {
    return find_overlap(space_, surface_, state_, q);
  }


  std::vector<SheetSection> ShellFields::sections() const
  {
    std::vector<SheetSection> result =
      shell_sections(
        space_, points_, [&](const unsigned int i) { return state_.node_thickness(i); },
        [&](const unsigned int i) { return state_.strain(i)[0]; },
        [&](const unsigned int i) { return material_.committed_stress(i)[0]; });
    for (unsigned int i = 0; i < result.size(); ++i)
      std::tie(result[i].clamping_pressure, result[i].contact_pressure) =
        std::minmax({state_.contact_pressure(Side::bottom, i), state_.contact_pressure(Side::top, i)});
    add_flow_stress(result);
    return result;
  }


  void ShellFields::add_flow_stress(std::vector<SheetSection> &sections) const
  {
    // Few sections are pressed on both faces, and a flow stress costs as much as the rest.
    const auto &cells = space_.mesh().cells();
    std::vector<unsigned int> n_points(sections.size(), 0);
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int a = 0; a <= space_.degree(); ++a)
        if (const unsigned int node = cells[c].nodes[a]; sections[node].clamping_pressure > 0.)
          for (unsigned int p = c * points_.per_cell(); p < (c + 1) * points_.per_cell(); ++p)
          {
            sections[node].flow_stress += flow_stress(p);
            ++n_points[node];
          }
    for (unsigned int i = 0; i < sections.size(); ++i)
      if (n_points[i] > 0)
        sections[i].flow_stress /= n_points[i];
  }
} // namespace deltaform
