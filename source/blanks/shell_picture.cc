// Picture of the accepted state of the shell.
#include "shell_fields.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// Write rr, zz, hoop, rz of a tensor that is diagonal along the meridian (unit vector @p along), hoop and normal.
    double *write_turned(const Mandel &e, const Tensor1 &along, double *values)
    {
      const double r = along[0], z = along[1];
      *values++ = e[0] * r * r + e[2] * z * z;
      *values++ = e[0] * z * z + e[2] * r * r;
      *values++ = e[1];
      *values++ = (e[0] - e[2]) * r * z;
      return values;
    }

    double mises_of(const Mandel &tau)
    {
      using dealii::Utilities::fixed_power;
      return std::sqrt(
        .5 * (fixed_power<2>(tau[0] - tau[1]) + fixed_power<2>(tau[1] - tau[2]) + fixed_power<2>(tau[2] - tau[0])));
    }

    /// A new field with room for @p n entries. Its values stay where they are when fields are added after it.
    double *add_field(Drawing &drawing,
                      const std::string &name,
                      const std::string &unit,
                      const bool per_point,
                      const unsigned int components,
                      const std::size_t n)
    {
      drawing.fields.push_back({name, unit, per_point, components, std::vector<double>(n * components)});
      return drawing.fields.back().values.data();
    }
  } // namespace


  Drawing ShellFields::draw(const Vector &q, const std::vector<DrawnField> &nodal) const
  {
    // One quadrilateral per element and layer interval: the layers' surfaces are their midpoints, the outermost ones
    // the faces.
    std::vector<double> level{-.5};
    for (unsigned int l = 0; l < points_.n_layers(); ++l)
      level.push_back(level[l] + points_.layer_weight(l) / points_.thickness());

    Drawing drawing;
    const unsigned int n_nodes = space_.n_nodes(), n_levels = level.size();
    drawing.points.reserve(static_cast<std::size_t>(n_nodes) * n_levels);
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      const double theta = surface_.director_angle(q, i);
      const Tensor1 d({-std::sin(theta), std::cos(theta)});
      const Point2 x = space_.position(q, i);
      for (const double s : level)
        drawing.points.push_back(x + s * state_.node_thickness(i) * d);
    }
    const std::size_t n_points = drawing.points.size();
    double *displacement = add_field(drawing, "displacement", "length", true, 2, n_points);
    double *thickness = add_field(drawing, "thickness", "length", true, 1, n_points);
    double *thinning = add_field(drawing, "thickness_strain", "1", true, 1, n_points);
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      const double strain = std::log(state_.node_thickness(i) / points_.thickness());
      for (unsigned int l = 0; l < n_levels; ++l)
      {
        *displacement++ = q[space_.dofs()[i][0]];
        *displacement++ = q[space_.dofs()[i][1]];
        *thickness++ = state_.node_thickness(i);
        *thinning++ = strain;
      }
    }
    for (const auto &field : nodal)
    {
      double *values = add_field(drawing, field.name, field.unit, true, 1, n_points);
      for (const double value : field.values)
        values = std::fill_n(values, n_levels, value);
    }
    draw_cells(q, drawing);
    return drawing;
  }


  void ShellFields::draw_cells(const Vector &q, Drawing &drawing) const
  {
    // Cells of degree 2 are drawn in two halves, each with the values of the nearer quadrature point.
    const std::size_t n_cells = space_.mesh().cells().size() * space_.degree() * points_.n_layers();
    const auto add = [&](const char *name, const char *unit, const unsigned int components) {
      return add_field(drawing, name, unit, false, components, n_cells);
    };
    double *strain_1 = add("strain_meridional", "1", 1);
    double *strain_2 = add("strain_hoop", "1", 1);
    double *equivalent = add("equivalent_plastic_strain", "1", 1);
    double *stress_1 = add("stress_meridional", "stress", 1);
    double *stress_2 = add("stress_hoop", "stress", 1);
    double *mises = add("stress_von_mises", "stress", 1);
    double *pressure = add("hydrostatic_pressure", "stress", 1);
    double *strain = add("strain", "1", 4);
    double *plastic = material_.plastic() ? add("plastic_strain", "1", 4) : nullptr;
    std::vector<std::pair<HistoryField, double *>> further; // what else the law remembers
    for (const HistoryField &field : material_.law().history_layout().fields())
      if (field.name != "plastic_strain" && field.name != "equivalent_plastic_strain")
        further.emplace_back(field, add(field.name.c_str(), field.unit.c_str(), field.size()));

    const unsigned int n_layers = points_.n_layers(), n_levels = n_layers + 1;
    drawing.cells.reserve(4 * n_cells);
    for (unsigned int c = 0; c < space_.mesh().cells().size(); ++c)
      for (unsigned int part = 0; part < space_.degree(); ++part)
      {
        const auto &nodes = space_.mesh().cells()[c].nodes;
        const unsigned int a = part == 0 ? nodes[0] : nodes[2];
        const unsigned int b = part + 1 == space_.degree() ? nodes[1] : nodes[2];
        const Tensor1 chord = space_.position(q, b) - space_.position(q, a), along = chord / chord.norm();
        for (unsigned int l = 0; l < n_layers; ++l)
        {
          for (const unsigned int corner :
               {a * n_levels + l, b * n_levels + l, b * n_levels + l + 1, a * n_levels + l + 1})
            drawing.cells.push_back(corner);
          const unsigned int i = (c * points_.per_cell() + part) * n_layers + l;
          const Mandel &tau = material_.committed_stress(i);
          *strain_1++ = state_.strain(i)[0];
          *strain_2++ = state_.strain(i)[1];
          *equivalent++ = material_.equivalent_plastic_strain(i);
          *stress_1++ = tau[0];
          *stress_2++ = tau[1];
          *mises++ = mises_of(tau);
          *pressure++ = -(tau[0] + tau[1] + tau[2]) / 3.;
          strain = write_turned(state_.strain(i), along, strain);
          if (plastic)
            plastic = write_turned(material_.plastic_strain(i), along, plastic);
          for (auto &[field, values] : further)
          {
            const double *const own = material_.history(i) + field.first;
            if (field.kind == HistoryKind::tensor)
              values = write_turned({{own[0], own[1], own[2], own[3]}}, along, values);
            else
              *values++ = *own;
          }
        }
      }
    draw_criteria(n_cells, drawing);
  }


  void ShellFields::draw_criteria(const std::size_t n_cells, Drawing &drawing) const
  {
    const PointCriteria &criteria = material_.criteria();
    for (unsigned int k = 0; k < criteria.n_fields(); ++k)
    {
      const bool of_layers = criteria.field(k).across() == PointField::Across::largest;
      double *values = add_field(drawing, criteria.column(k), criteria.field(k).unit(), false, 1, n_cells);
      for (unsigned int c = 0; c < space_.mesh().cells().size(); ++c)
        for (unsigned int part = 0; part < space_.degree(); ++part)
          for (unsigned int l = 0; l < points_.n_layers(); ++l)
          {
            const unsigned int point = c * points_.per_cell() + part;
            *values++ =
              of_layers ? criteria.value(std::size_t(point) * points_.n_layers() + l, k) : criterion(point, k);
          }
    }
  }
} // namespace deltaform
