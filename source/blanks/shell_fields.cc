// Tables of the accepted state of the shell.
#include "shell.h"

#include <deltaform/base/text.h>

#include <numeric>

namespace deltaform
{
  std::string Shell::describe_dof(const DofIndex dof) const
  {
    const std::array<std::string, 3> names{{"u_r", "u_z", "rotation"}};
    for (unsigned int i = 0; i < node_dofs_.size(); ++i)
      for (unsigned int k = 0; k < 3; ++k)
        if (node_dofs_[i][k] == dof)
          return "node " + std::to_string(i) + " (R0 = " + text::format(mesh_.nodes()[i][0]) +
                 ", Z0 = " + text::format(mesh_.nodes()[i][1]) + "), " + names[k];
    return "unknown " + std::to_string(dof);
  }


  std::vector<unsigned int> Shell::face_nodes(const std::string & /*face*/) const
  {
    std::vector<unsigned int> all(node_dofs_.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }


  Table Shell::profile(const Vector &q) const
  {
    Table table;
    table.names = {"R0",
                   "r",
                   "z",
                   "rotation",
                   "thickness",
                   "eps_meridional",
                   "eps_hoop",
                   "eps_thickness",
                   "equivalent_plastic_strain",
                   "stress_meridional_bottom",
                   "stress_meridional_mid",
                   "stress_meridional_top",
                   "stress_hoop_bottom",
                   "stress_hoop_mid",
                   "stress_hoop_top",
                   "S0",
                   "u_r",
                   "u_z"};
    table.units = {"length",
                   "length",
                   "length",
                   "rad",
                   "length",
                   "1",
                   "1",
                   "1",
                   "1",
                   "stress",
                   "stress",
                   "stress",
                   "stress",
                   "stress",
                   "stress",
                   "length",
                   "length",
                   "length"};

    const unsigned int n = points_.size(), middle = n_layers_ / 2;
    std::vector<std::vector<double>> values(11, std::vector<double>(n, 0.));
    for (unsigned int p = 0; p < n; ++p)
    {
      const auto layer = [&](const unsigned int l) { return p * n_layers_ + l; };
      for (unsigned int l = 0; l < n_layers_; ++l)
      {
        const double w = layer_weight_[l] / thickness_;
        values[1][p] += w * committed_strain_[layer(l)][0];
        values[2][p] += w * committed_strain_[layer(l)][1];
        values[4][p] += w * material_.equivalent_plastic_strain(layer(l));
      }
      values[0][p] = thickness_ * thickness_ratio_[p];
      values[3][p] = std::log(thickness_ratio_[p]);
      for (unsigned int k = 0; k < 2; ++k)
      {
        values[5 + 3 * k][p] = material_.committed_stress(layer(0))[k];
        values[6 + 3 * k][p] = material_.committed_stress(layer(middle))[k];
        values[7 + 3 * k][p] = material_.committed_stress(layer(n_layers_ - 1))[k];
      }
    }
    for (auto &column : values)
      column = to_nodes(column);
    for (unsigned int i = 0; i < node_dofs_.size(); ++i)
    {
      const Point2 x = position(q, i);
      std::vector<double> row{mesh_.nodes()[i][0], x[0], x[1], rotation(q, i)};
      for (const auto &column : values)
        row.push_back(column[i]);
      row.push_back(mesh_.arc_length()[i]);
      // Displacements on their own: coordinates do not print enough digits of small ones.
      row.push_back(q[node_dofs_[i][0]]);
      row.push_back(q[node_dofs_[i][1]]);
      table.rows.push_back(row);
    }
    return table;
  }


  std::vector<double> Shell::flow_stress(const Side side) const
  {
    const unsigned int outer = side == Side::top ? n_layers_ - 1 : 0;
    std::vector<double> values(points_.size());
    for (unsigned int p = 0; p < values.size(); ++p)
      values[p] = material_.flow_stress(static_cast<std::size_t>(p) * n_layers_ + outer);
    return to_nodes(values);
  }


  std::vector<SheetSection> Shell::sections() const
  {
    const unsigned int n = points_.size();
    std::vector<double> stretch(n, 0.), stress(n, 0.);
    for (unsigned int p = 0, i = 0; p < n; ++p)
      for (unsigned int l = 0; l < n_layers_; ++l, ++i)
      {
        const double w = layer_weight_[l] / thickness_;
        stretch[p] += w * committed_strain_[i][0];
        stress[p] += w * material_.committed_stress(i)[0];
      }
    const auto mean_stretch = to_nodes(stretch), mean_stress = to_nodes(stress);
    const auto squeeze = [&](const unsigned int i) {
      return std::min(contact_pressure_[0][i], contact_pressure_[1][i]);
    };
    std::vector<SheetSection> result(node_dofs_.size());
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] = {mesh_.nodes()[i][0],
                   node_thickness_[i],
                   mean_stretch[i],
                   -std::log(node_thickness_[i] / thickness_),
                   mean_stress[i],
                   squeeze(i),
                   0.};
    // Few sections are squeezed, and a flow stress costs as much as the rest.
    std::vector<double> weight(result.size(), 0.);
    for (unsigned int c = 0; c < mesh_.cells().size(); ++c)
      for (unsigned int a = 0; a <= degree_; ++a)
        if (const unsigned int node = mesh_.cells()[c].nodes[a]; squeeze(node) > 0.)
          for (unsigned int p = c * n_points_per_cell_; p < (c + 1) * n_points_per_cell_; ++p)
          {
            for (unsigned int l = 0; l < n_layers_; ++l)
              result[node].flow_stress +=
                layer_weight_[l] * material_.flow_stress(p * n_layers_ + l);
            weight[node] += thickness_;
          }
    for (unsigned int i = 0; i < result.size(); ++i)
      if (weight[i] > 0.)
        result[i].flow_stress /= weight[i];
    return result;
  }
} // namespace deltaform
