// Picture of the accepted state of the solid.
#include "solid.h"
#include "solid_stress.h"

#include <deltaform/base/ranks.h>
#include <deltaform/kinematics/logarithmic_strain.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    constexpr double root_half = .70710678118654752440;

    /// What is drawn of a cell, or of a part of it. Tensors in Mandel order.
    struct CellValues
    {
      double equivalent = 0;
      Mandel stress{}, strain{}, plastic{};
    };

    void append(std::vector<double> &values, const Mandel &tensor)
    {
      values.insert(values.end(), {tensor[0], tensor[1], tensor[2], root_half * tensor[3]});
    }

    /// A tensor of the undeformed body, turned with the material: R t R^T, where f = R U is the in-plane deformation.
    Mandel turned(const Mandel &t, const std::array<double, 4> &f)
    {
      const double length = std::hypot(f[0] + f[3], f[2] - f[1]);
      const double c = (f[0] + f[3]) / length, s = (f[2] - f[1]) / length, shear = root_half * t[3];
      return {{c * c * t[0] - 2 * c * s * shear + s * s * t[1],
               s * s * t[0] + 2 * c * s * shear + c * c * t[1],
               t[2],
               (c * s * (t[0] - t[1]) + (c * c - s * s) * shear) / root_half}};
    }
  } // namespace


  Mandel Solid::total_strain(const Deformation &F) const
  {
    const auto &f = F.f;
    if (!finite_)
      return {{f[0] - 1., f[3] - 1., F.hoop - 1., root_half * (f[1] + f[2])}};
    return LogarithmicStrain::strain(
      {f[0] * f[0] + f[1] * f[1], f[2] * f[2] + f[3] * f[3], F.hoop * F.hoop, f[0] * f[2] + f[1] * f[3]});
  }


  Mandel Solid::plastic_strain(const unsigned int point, const Deformation &F) const
  {
    if (!finite_)
      return material_.plastic_strain(point);
    const auto &inverse = plastic_metric_[point];
    Mandel result = LogarithmicStrain::strain({inverse[0], inverse[1], inverse[2], inverse[3]});
    for (double &component : result)
      component = -component;
    return turned(result, F.f);
  }


  std::vector<double>
  Solid::remembered(const HistoryField &field, const unsigned int first_point, const unsigned int n_points) const
  {
    std::vector<double> mean(field.size(), 0.);
    for (unsigned int i = first_point; i < first_point + n_points; ++i)
      for (unsigned int k = 0; k < field.size(); ++k)
        mean[k] += material_.history(i)[field.first + k] / n_points;
    if (field.kind == HistoryKind::tensor)
      mean[3] *= root_half;
    return mean;
  }


  void Solid::draw_cells(const Vector &q, Drawing &drawing) const
  {
    const auto add_field = [&](const std::string &name, const std::string &unit, const unsigned int components) {
      drawing.fields.push_back({name, unit, false, components, {}});
      return &drawing.fields.back().values;
    };
    const auto &fields = material_.law().history_layout().fields();
    drawing.fields.reserve(drawing.fields.size() + 10 + fields.size());
    auto *const equivalent = add_field("equivalent_plastic_strain", "1", 1);
    const std::array<std::vector<double> *, 4> stress = {{add_field("stress_rr", "stress", 1),
                                                          add_field("stress_zz", "stress", 1),
                                                          add_field("stress_hoop", "stress", 1),
                                                          add_field("stress_rz", "stress", 1)}};
    auto *const von_mises = add_field("stress_von_mises", "stress", 1);
    auto *const mean = add_field("stress_mean", "stress", 1);
    auto *const pressure = add_field("hydrostatic_pressure", "stress", 1);
    auto *const strain = add_field("strain", "1", 4);
    auto *const plastic = material_.plastic() ? add_field("plastic_strain", "1", 4) : nullptr;
    std::vector<std::pair<HistoryField, std::vector<double> *>> further; // what else the law remembers
    for (const HistoryField &field : fields)
      if (field.name != "plastic_strain" && field.name != "equivalent_plastic_strain")
        further.emplace_back(field, add_field(field.name, field.unit, field.size()));

    // A cell of degree 2 is drawn in four quarters, each with the values of its own corner's quadrature point.
    constexpr unsigned int quarters[4][4] = {{0, 6, 8, 4}, {6, 1, 5, 8}, {4, 8, 7, 2}, {8, 5, 3, 7}};
    constexpr unsigned int whole[4] = {0, 1, 3, 2};
    constexpr unsigned int corner_point[4] = {0, 2, 6, 8};
    for (unsigned int c = 0; c < space_.cells().size(); ++c)
      for (unsigned int part = 0; part < (space_.degree() == 1 ? 1 : 4); ++part)
      {
        for (const auto corner : space_.degree() == 1 ? whole : quarters[part])
          drawing.cells.push_back(space_.cells()[c][corner]);
        CellValues values;
        const unsigned int n = space_.degree() == 1 ? points_.per_cell() : 1;
        const unsigned int first = space_.degree() == 1 ? 0 : corner_point[part];
        for (unsigned int p = first; p < first + n; ++p)
        {
          const unsigned int i = c * points_.per_cell() + p;
          const Deformation F = points_.deformation(q, c, p);
          const Mandel e = total_strain(F);
          const Mandel e_p = plastic ? plastic_strain(i, F) : Mandel{};
          values.equivalent += material_.equivalent_plastic_strain(i) / n;
          for (unsigned int k = 0; k < 4; ++k)
          {
            values.stress[k] += material_.committed_stress(i)[k] / n;
            values.strain[k] += e[k] / n;
            values.plastic[k] += e_p[k] / n;
          }
        }
        const Mandel &tau = values.stress;
        equivalent->push_back(values.equivalent);
        for (unsigned int k = 0; k < 4; ++k)
          stress[k]->push_back(tau[k] * (k == 3 ? std::sqrt(.5) : 1.));
        von_mises->push_back(mises(tau));
        mean->push_back((tau[0] + tau[1] + tau[2]) / 3.);
        pressure->push_back(-mean->back());
        append(*strain, values.strain);
        if (plastic)
          append(*plastic, values.plastic);
        for (const auto &[field, drawn] : further)
        {
          const auto own = remembered(field, c * points_.per_cell() + first, n);
          drawn->insert(drawn->end(), own.begin(), own.end());
        }
      }
  }


  Drawing Solid::draw(const Vector &state, const std::vector<DrawnField> &nodal) const
  {
    Vector storage;
    const Vector &q = space_.hanging().with_hanging(state, storage);
    Drawing drawing;
    for (unsigned int i = 0; i < space_.nodes().size(); ++i)
      drawing.points.push_back(space_.position(q, i));
    drawing.fields.push_back({"displacement", "length", true, 2, {}});
    for (const auto &dofs : space_.dofs())
    {
      drawing.fields.back().values.push_back(q[dofs[0]]);
      drawing.fields.back().values.push_back(q[dofs[1]]);
    }
    drawing.fields.insert(drawing.fields.end(), nodal.begin(), nodal.end());
    draw_cells(q, drawing);
    drawing.cells = ranks::gather(drawing.cells);
    for (auto &field : drawing.fields)
      if (!field.per_point)
        field.values = ranks::gather(field.values);
    return drawing;
  }
} // namespace deltaform
