// Tables and pictures of the accepted state of the shell.
#include <deltaform/base/text.h>
#include <deltaform/blanks/shell.h>

#include <deal.II/base/utilities.h>

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
        values[4][p] += w * material_->equivalent_plastic_strain(history_.committed(layer(l)));
      }
      values[0][p] = thickness_ * thickness_ratio_[p];
      values[3][p] = std::log(thickness_ratio_[p]);
      for (unsigned int k = 0; k < 2; ++k)
      {
        values[5 + 3 * k][p] = committed_stress_[layer(0)][k];
        values[6 + 3 * k][p] = committed_stress_[layer(middle)][k];
        values[7 + 3 * k][p] = committed_stress_[layer(n_layers_ - 1)][k];
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


  std::vector<SheetSection> Shell::sections() const
  {
    const unsigned int n = points_.size();
    std::vector<double> stretch(n, 0.), stress(n, 0.);
    for (unsigned int p = 0, i = 0; p < n; ++p)
      for (unsigned int l = 0; l < n_layers_; ++l, ++i)
      {
        const double w = layer_weight_[l] / thickness_;
        stretch[p] += w * committed_strain_[i][0];
        stress[p] += w * committed_stress_[i][0];
      }
    const auto mean_stretch = to_nodes(stretch), mean_stress = to_nodes(stress);
    const auto squeeze = [&](const unsigned int i)
    { return std::min(contact_pressure_[0][i], contact_pressure_[1][i]); };
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
                layer_weight_[l] * material_->flow_stress(history_.committed(p * n_layers_ + l));
            weight[node] += thickness_;
          }
    for (unsigned int i = 0; i < result.size(); ++i)
      if (weight[i] > 0.)
        result[i].flow_stress /= weight[i];
    return result;
  }


  Drawing Shell::draw(const Vector &q, const std::vector<DrawnField> &nodal) const
  {
    // One quadrilateral per element and layer interval: the layers' surfaces are their midpoints, the outermost ones
    // the faces.
    std::vector<double> level(n_layers_ + 1);
    level[0] = -.5;
    for (unsigned int l = 0; l < n_layers_; ++l)
      level[l + 1] = level[l] + layer_weight_[l] / thickness_;

    Drawing drawing;
    const unsigned int n_nodes = node_dofs_.size(), n_levels = level.size();
    drawing.points.reserve(static_cast<std::size_t>(n_nodes) * n_levels);
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      const double theta = membrane_ ? membrane_angle(q, i) : node_angle_[i] + rotation(q, i);
      const Tensor1 d({-std::sin(theta), std::cos(theta)});
      const Point2 x = position(q, i);
      for (const double s : level)
        drawing.points.push_back(x + s * node_thickness_[i] * d);
    }
    // Cells of degree 2 are drawn in two halves, each with the values of the nearer quadrature point.
    const std::size_t n_points = drawing.points.size(), n_cells = mesh_.cells().size() * degree_ * n_layers_;
    drawing.fields.reserve(16 + nodal.size());
    const auto add_field = [&](const std::string &name,
                               const std::string &unit,
                               const bool per_point,
                               const unsigned int components) -> double *
    {
      drawing.fields.push_back({name, unit, per_point, components, {}});
      auto &values = drawing.fields.back().values;
      values.resize((per_point ? n_points : n_cells) * components);
      return values.data();
    };
    double *displacement = add_field("displacement", "length", true, 2);
    double *thickness    = add_field("thickness", "length", true, 1);
    double *thinning     = add_field("thickness_strain", "1", true, 1);
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      const double strain = std::log(node_thickness_[i] / thickness_);
      for (unsigned int l = 0; l < n_levels; ++l)
      {
        *displacement++ = q[node_dofs_[i][0]];
        *displacement++ = q[node_dofs_[i][1]];
        *thickness++    = node_thickness_[i];
        *thinning++     = strain;
      }
    }
    for (const auto &field : nodal)
    {
      double *values = add_field(field.name, field.unit, true, 1);
      for (const double value : field.values)
        values = std::fill_n(values, n_levels, value);
    }
    double *strain_1 = add_field("strain_meridional", "1", false, 1);
    double *strain_2 = add_field("strain_hoop", "1", false, 1);
    double *plastic  = add_field("equivalent_plastic_strain", "1", false, 1);
    double *stress_1 = add_field("stress_meridional", "stress", false, 1);
    double *stress_2 = add_field("stress_hoop", "stress", false, 1);
    double *mises    = add_field("stress_von_mises", "stress", false, 1);

    drawing.cells.reserve(4 * n_cells);
    for (unsigned int c = 0; c < mesh_.cells().size(); ++c)
      for (unsigned int part = 0; part < degree_; ++part)
      {
        const auto &nodes    = mesh_.cells()[c].nodes;
        const unsigned int a = part == 0 ? nodes[0] : nodes[2];
        const unsigned int b = part + 1 == degree_ ? nodes[1] : nodes[2];
        for (unsigned int l = 0; l < n_layers_; ++l)
        {
          for (const unsigned int corner :
               {a * n_levels + l, b * n_levels + l, b * n_levels + l + 1, a * n_levels + l + 1})
            drawing.cells.push_back(corner);
          const unsigned int i = (c * n_points_per_cell_ + part) * n_layers_ + l;
          const Mandel &tau    = committed_stress_[i];
          *strain_1++          = committed_strain_[i][0];
          *strain_2++          = committed_strain_[i][1];
          *plastic++           = material_->equivalent_plastic_strain(history_.committed(i));
          *stress_1++          = tau[0];
          *stress_2++          = tau[1];
          *mises++             = std::sqrt(.5 * (dealii::Utilities::fixed_power<2>(tau[0] - tau[1]) +
                                     dealii::Utilities::fixed_power<2>(tau[1] - tau[2]) +
                                     dealii::Utilities::fixed_power<2>(tau[2] - tau[0])));
        }
      }
    return drawing;
  }
} // namespace deltaform
