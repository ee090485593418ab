#include "solid_picture.h"
#include "solid_stress.h"

#include <cmath>

namespace deltaform
{
  namespace
  {
    constexpr double root_half = .70710678118654752440;

    void append(std::vector<double> &values, const Mandel &tensor)
    {
      values.insert(values.end(), {tensor[0], tensor[1], tensor[2], root_half * tensor[3]});
    }
  } // namespace


  SolidPicture::SolidPicture(const SolidDiscretization &body,
                             const MaterialPoints &material,
                             const SolidMotion &motion,
                             Drawing &drawing)
    : body_(body), material_(material), motion_(motion), drawing_(drawing)
  {
    const auto &fields = material_.law().history_layout().fields();
    const PointCriteria &criteria = material_.criteria();
    // Values stay where they are.
    drawing_.fields.reserve(drawing_.fields.size() + 10 + fields.size() + criteria.n_fields());
    equivalent_ = add("equivalent_plastic_strain", "1", 1);
    stress_ = {{add("stress_rr", "stress", 1),
                add("stress_zz", "stress", 1),
                add("stress_hoop", "stress", 1),
                add("stress_rz", "stress", 1)}};
    von_mises_ = add("stress_von_mises", "stress", 1);
    mean_ = add("stress_mean", "stress", 1);
    pressure_ = add("hydrostatic_pressure", "stress", 1);
    strain_ = add("strain", "1", 4);
    plastic_ = material_.plastic() ? add("plastic_strain", "1", 4) : nullptr;
    for (const HistoryField &field : fields)
      if (field.name != "plastic_strain" && field.name != "equivalent_plastic_strain")
        further_.emplace_back(field, add(field.name, field.unit, field.size()));
    for (unsigned int k = 0; k < criteria.n_fields(); ++k)
      criteria_values_.push_back(add(criteria.column(k), criteria.field(k).unit(), 1));
  }


  SolidPicture::Values
  SolidPicture::add(const std::string &name, const std::string &unit, const unsigned int n_components)
  {
    drawing_.fields.push_back({name, unit, false, n_components, {}});
    return &drawing_.fields.back().values;
  }


  void SolidPicture::draw_cells(const Vector &q)
  {
    // A cell of degree 2 is drawn in four quarters, each with the values of its own corner's quadrature point.
    constexpr unsigned int quarters[4][4] = {{0, 6, 8, 4}, {6, 1, 5, 8}, {4, 8, 7, 2}, {8, 5, 3, 7}};
    constexpr unsigned int whole[4] = {0, 1, 3, 2};
    constexpr unsigned int corner_point[4] = {0, 2, 6, 8};
    const auto &cells = body_.space().cells();
    const bool in_one = body_.space().degree() == 1;
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int part = 0; part < (in_one ? 1 : 4); ++part)
      {
        for (const auto corner : in_one ? whole : quarters[part])
          drawing_.cells.push_back(cells[c][corner]);
        if (in_one)
          draw_part(q, c, 0, body_.points().per_cell());
        else
          draw_part(q, c, corner_point[part], 1);
      }
  }


  void SolidPicture::draw_part(const Vector &q,
                               const unsigned int cell,
                               const unsigned int first,
                               const unsigned int n_points)
  {
    const unsigned int first_point = cell * body_.points().per_cell() + first;
    double equivalent = 0.;
    Mandel tau{}, strain{}, plastic{};
    for (unsigned int p = 0; p < n_points; ++p)
    {
      const unsigned int i = first_point + p;
      const Deformation F = body_.points().deformation(q, cell, first + p);
      const Mandel e = motion_.strain(F);
      Mandel e_p{};
      if (plastic_)
        e_p = motion_.finite() ? motion_.plastic_strain(i, F) : material_.plastic_strain(i);
      equivalent += material_.equivalent_plastic_strain(i) / n_points;
      for (unsigned int k = 0; k < 4; ++k)
      {
        tau[k] += material_.committed_stress(i)[k] / n_points;
        strain[k] += e[k] / n_points;
        plastic[k] += e_p[k] / n_points;
      }
    }
    equivalent_->push_back(equivalent);
    for (unsigned int k = 0; k < 4; ++k)
      stress_[k]->push_back(tau[k] * (k == 3 ? std::sqrt(.5) : 1.));
    von_mises_->push_back(mises(tau));
    mean_->push_back((tau[0] + tau[1] + tau[2]) / 3.);
    pressure_->push_back(-mean_->back());
    append(*strain_, strain);
    if (plastic_)
      append(*plastic_, plastic);
    for (const auto &[field, values] : further_)
    {
      const auto own = remembered(field, first_point, n_points);
      values->insert(values->end(), own.begin(), own.end());
    }
    for (unsigned int k = 0; k < criteria_values_.size(); ++k)
    {
      double mean = 0.;
      for (unsigned int i = first_point; i < first_point + n_points; ++i)
        mean += material_.criteria().value(i, k) / n_points;
      criteria_values_[k]->push_back(mean);
    }
  }


  std::vector<double> SolidPicture::remembered(const HistoryField &field,
                                               const unsigned int first_point,
                                               const unsigned int n_points) const
  {
    std::vector<double> mean(field.size(), 0.);
    const bool tensor = field.kind == HistoryKind::tensor;
    for (unsigned int i = first_point; i < first_point + n_points; ++i)
    {
      const Mandel turned = tensor ? material_.tensor(i, field) : Mandel{};
      for (unsigned int k = 0; k < field.size(); ++k)
        mean[k] += (tensor ? turned[k] : material_.history(i)[field.first]) / n_points;
    }
    if (tensor)
      mean[3] *= root_half;
    return mean;
  }
} // namespace deltaform
