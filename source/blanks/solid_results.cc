// Accepting an increment of the solid, its energies and measures.
#include "solid.h"

#include <deltaform/base/ranks.h>
#include <deltaform/kinematics/logarithmic_strain.h>
#include <deltaform/materials/flow_error.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    constexpr double root_2 = 1.41421356237309504880;

    using Turn = Solid::Turn;

    /// The in-plane rotation of a deformation gradient: polar decomposition, tan(angle) = s/c.
    Turn turn(const std::array<double, 4> &f)
    {
      const double c = f[0] + f[3], s = f[2] - f[1], inverse = 1. / (c * c + s * s);
      return {inverse * (c * c - s * s), inverse * 2 * c * s};
    }

    /// @p ratio times as far. Increments are mostly as long as the last one.
    Turn turn(const Turn &by, const double ratio)
    {
      if (std::abs(ratio - 1.) < 1e-12)
        return by;
      const double twice = ratio * std::atan2(by.sine, by.cosine);
      return {std::cos(twice), std::sin(twice)};
    }

    Mandel turned(const Mandel &t, const Turn &by)
    {
      const auto [c, s] = by;
      const double mean = .5 * (t[0] + t[1]), half = .5 * (t[0] - t[1]), shear = t[3] / root_2;
      return {{mean + half * c - shear * s, mean - half * c + shear * s, t[2], root_2 * (half * s + shear * c)}};
    }
  } // namespace


  Deformation Solid::increment(const unsigned int point) const
  {
    const auto &a = deformation_[point].f, &b = committed_deformation_[point].f;
    const double inverse = 1. / (b[0] * b[3] - b[1] * b[2]);
    Deformation result;
    result.f = {{inverse * (a[0] * b[3] - a[1] * b[2]),
                 inverse * (a[1] * b[0] - a[0] * b[1]),
                 inverse * (a[2] * b[3] - a[3] * b[2]),
                 inverse * (a[3] * b[0] - a[2] * b[1])}};
    result.hoop = deformation_[point].hoop / committed_deformation_[point].hoop;
    return result;
  }


  void Solid::begin_increment(const double duration, const double ratio)
  {
    if (!material_.begin_increment(duration, ratio) || !finite_)
      return;
    // The last flow is known in the axes of the last increment's end: they go on turning.
    for (unsigned int i = 0; i < spin_.size(); ++i)
    {
      const Turn by = turn(spin_[i], ratio);
      for (const HistoryField &field : material_.law().history_layout().fields())
        if (field.kind == HistoryKind::tensor)
        {
          double *const flow = material_.carried(i) + field.first;
          const Mandel now = turned({{flow[0], flow[1], flow[2], flow[3]}}, by);
          std::copy(now.begin(), now.end(), flow);
        }
    }
  }


  double Solid::flow_error() const
  {
    MeanFlowError error;
    for (unsigned int i = 0; i < points_.size(); ++i)
    {
      const double flow = material_.flow(i);
      const Mandel start =
        finite_ && flow > 0. ? turned(material_.committed_stress(i), turn(increment(i).f))
                             : material_.committed_stress(i);
      error.add(points_[i].weight * flow, start, material_.stress(i));
    }
    error.astray = ranks::sum(error.astray);
    error.flow = ranks::sum(error.flow);
    return error.value();
  }


  IncrementSize Solid::increment_size(const Vector &dq) const
  {
    Vector storage;
    const Vector &du = linear_ ? space_.hanging().with_hanging(dq, storage) : dq;
    double strain = 0., most = 1.; // of small strains; of squared stretches and their inverses
    double sine = 0., cosine = 1.; // of the largest angle so far, times a length
    for (unsigned int i = 0; i < points_.size(); ++i)
    {
      // Where the law is linear points are visited at the commit only, and no strain is too large.
      const Deformation d =
        linear_ ? points_.deformation(du, i / points_.per_cell(), i % points_.per_cell()) : increment(i);
      const auto &f = d.f;
      const double own_sine = std::abs(f[2] - f[1]), own_cosine = f[0] + f[3];
      if (own_sine * cosine > sine * own_cosine)
      {
        sine = own_sine;
        cosine = own_cosine;
      }
      if (finite_)
      {
        const double xx = f[0] * f[0] + f[1] * f[1], yy = f[2] * f[2] + f[3] * f[3], xy = f[0] * f[2] + f[1] * f[3];
        const double j = f[0] * f[3] - f[1] * f[2], hoop = d.hoop * d.hoop;
        const double longest = .5 * (xx + yy) + std::sqrt(.25 * (xx - yy) * (xx - yy) + xy * xy);
        most = std::max({most, longest, longest / (j * j), hoop, 1. / hoop});
        continue;
      }
      if (linear_)
        continue;
      const Deformation &now = deformation_[i], &before = committed_deformation_[i];
      const auto &a = now.f, &b = before.f;
      const Mandel e{{a[0] - b[0], a[3] - b[3], now.hoop - before.hoop, (a[1] - b[1] + a[2] - b[2]) / root_2}};
      const double radius = std::hypot(.5 * (e[0] - e[1]), e[3] / root_2);
      strain = std::max({strain, .5 * std::abs(e[0] + e[1]) + radius, std::abs(e[2])});
    }
    return {ranks::max(finite_ ? .5 * std::log(most) : strain), ranks::max(std::atan2(sine, cosine))};
  }


  void Solid::forget_energy()
  {
    material_.forget_energy();
  }


  void Solid::set_plastic_metric(const unsigned int point, Mandel e)
  {
    // C_p^-1 = F^-1 exp(2 e) F^-T with the elastic strain e: its deviator is known from the stress; its trace is ln J,
    // as plastic flow preserves the volume, and not that of the stress, which the volume of the cell has a part in.
    const auto &f = deformation_[point].f;
    const double hoop = deformation_[point].hoop, in_j = f[0] * f[3] - f[1] * f[2];
    const double mean = (std::log(in_j * hoop) - e[0] - e[1] - e[2]) / 3.;
    for (unsigned int k = 0; k < 3; ++k)
      e[k] += mean;
    const AxialTensor b = LogarithmicStrain::inverse(e);
    const double inverse = 1. / in_j;
    const double g[4] = {inverse * f[3], -inverse * f[1], -inverse * f[2], inverse * f[0]};
    plastic_metric_[point] = {{g[0] * g[0] * b.xx + 2 * g[0] * g[1] * b.xy + g[1] * g[1] * b.yy,
                               g[2] * g[2] * b.xx + 2 * g[2] * g[3] * b.xy + g[3] * g[3] * b.yy,
                               b.zz / (hoop * hoop),
                               g[0] * g[2] * b.xx + (g[0] * g[3] + g[1] * g[2]) * b.xy + g[1] * g[3] * b.yy}};
  }


  void Solid::commit(const Vector &q)
  {
    if (linear_)
      update_stress(q);
    const bool may_flow = material_.plastic();
    double elastic = 0., plastic = 0.;
    for (unsigned int i = 0; i < points_.size(); ++i)
    {
      if (material_.counts_energy())
        elastic += points_[i].weight * material_.law().elastic_energy(material_.stress(i));
      if (!may_flow)
        continue;
      const Turn by = finite_ ? turn(increment(i).f) : Turn();
      if (!spin_.empty())
        spin_[i] = by;
      const Mandel before = material_.plastic_strain(i);
      const Mandel after = material_.trial_plastic_strain(i);
      if (before == after)
        continue;
      if (material_.counts_energy())
      {
        // The flow takes place in the axes of now: the last stress is turned along.
        const Mandel start = finite_ ? turned(material_.committed_stress(i), by) : material_.committed_stress(i);
        for (unsigned int k = 0; k < 4; ++k)
          plastic += .5 * points_[i].weight * (material_.stress(i)[k] + start[k]) * (after[k] - before[k]);
      }
      if (finite_)
        set_plastic_metric(i, material_.law().elastic_strain(material_.stress(i)));
    }
    if (material_.counts_energy())
      material_.add_energy(ranks::sum(elastic), ranks::sum(plastic));
    material_.commit();
    // What becomes trial is overwritten before it is read.
    committed_deformation_.swap(deformation_);
    update_areas(q);
    update_thickness(q);
    update_places(q);
  }


  void Solid::update_places(const Vector &q)
  {
    if (refinement_.active)
      committed_places_ = positions(q);
  }


  void Solid::update_thickness(const Vector &q)
  {
    smallest_thickness_ = std::numeric_limits<double>::infinity();
    for (const auto &[bottom, top] : boundary_.columns())
      smallest_thickness_ = std::min(smallest_thickness_, space_.position(q, top).distance(space_.position(q, bottom)));
    if (boundary_.columns().empty())
    {
      for (const auto node : faces_[1].nodes())
        smallest_thickness_ = std::min(smallest_thickness_, faces_[0].distance(q, space_.position(q, node)));
      if (!std::isfinite(smallest_thickness_))
        smallest_thickness_ = space_.mesh().thickness();
    }
  }


  void Solid::set_contact_pressure(const Side, const std::vector<double> &)
  {
    // A solid carries its transverse stress itself.
  }


  BlankEnergy Solid::energy() const
  {
    return material_.energy();
  }


  double Solid::smallest_thickness() const
  {
    return smallest_thickness_;
  }
} // namespace deltaform
