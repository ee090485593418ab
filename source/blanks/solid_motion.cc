#include "solid_motion.h"

#include <deltaform/kinematics/logarithmic_strain.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    constexpr double root_2 = 1.41421356237309504880, root_half = .70710678118654752440;

    /// The in-plane rotation of a deformation gradient: polar decomposition, tan(angle) = s/c.
    Turn turn_of(const std::array<double, 4> &f)
    {
      const double c = f[0] + f[3], s = f[2] - f[1], inverse = 1. / (c * c + s * s);
      return {inverse * (c * c - s * s), inverse * 2 * c * s};
    }


    /// @p ratio times as far. Increments are mostly as long as the last one.
    Turn times(const Turn &by, const double ratio)
    {
      if (std::abs(ratio - 1.) < 1e-12)
        return by;
      const double twice = ratio * std::atan2(by.sine, by.cosine);
      return {std::cos(twice), std::sin(twice)};
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


    /// The largest angle of many points, each by a sine and a cosine times a length.
    class LargestAngle
    {
    public:
      void add(const std::array<double, 4> &f, const unsigned int point)
      {
        const double own_sine = std::abs(f[2] - f[1]), own_cosine = f[0] + f[3];
        if (own_sine * cosine_ > sine_ * own_cosine)
        {
          sine_ = own_sine;
          cosine_ = own_cosine;
          point_ = point;
        }
      }

      double value() const
      {
        return std::atan2(sine_, cosine_);
      }

      unsigned int point() const
      {
        return point_;
      }

    private:
      double sine_ = 0., cosine_ = 1.;
      unsigned int point_ = 0;
    };


    /// The largest of the squared principal stretches and their inverses.
    double largest_square(const Deformation &d)
    {
      const auto &f = d.f;
      const double xx = f[0] * f[0] + f[1] * f[1], yy = f[2] * f[2] + f[3] * f[3], xy = f[0] * f[2] + f[1] * f[3];
      const double j = f[0] * f[3] - f[1] * f[2], hoop = d.hoop * d.hoop;
      const double longest = .5 * (xx + yy) + std::sqrt(.25 * (xx - yy) * (xx - yy) + xy * xy);
      return std::max({longest, longest / (j * j), hoop, 1. / hoop});
    }


    /// The largest principal value of the change of a small strain.
    double largest_change(const Deformation &now, const Deformation &before)
    {
      const auto &a = now.f, &b = before.f;
      const Mandel e{{a[0] - b[0], a[3] - b[3], now.hoop - before.hoop, (a[1] - b[1] + a[2] - b[2]) / root_2}};
      const double radius = std::hypot(.5 * (e[0] - e[1]), e[3] / root_2);
      return std::max(.5 * std::abs(e[0] + e[1]) + radius, std::abs(e[2]));
    }
  } // namespace


  Mandel Turn::operator()(const Mandel &t) const
  {
    const double c = cosine, s = sine;
    const double mean = .5 * (t[0] + t[1]), half = .5 * (t[0] - t[1]), shear = t[3] / root_2;
    return {{mean + half * c - shear * s, mean - half * c + shear * s, t[2], root_2 * (half * s + shear * c)}};
  }


  void SolidMotion::reset(const std::size_t n, const bool remembers_turns)
  {
    if (remembers_turns)
      turns_.assign(n, Turn());
    deformation_.assign(n, Deformation());
    committed_deformation_ = deformation_;
    volume_offset_.assign(n, 0.);
    plastic_metric_.assign(n, {{1., 1., 1., 0.}});
  }


  Deformation SolidMotion::increment(const std::size_t point) const
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


  Turn SolidMotion::turn(const std::size_t point) const
  {
    return finite_ ? turn_of(increment(point).f) : Turn();
  }


  SolidIncrementSize SolidMotion::increment_size() const
  {
    double most = finite_ ? 1. : 0.; // of squared stretches and their inverses; of small strains
    unsigned int strained = 0;
    LargestAngle angle;
    for (unsigned int i = 0; i < deformation_.size(); ++i)
    {
      const Deformation d = increment(i);
      angle.add(d.f, i);
      if (const double size = finite_ ? largest_square(d) : largest_change(deformation_[i], committed_deformation_[i]);
          size > most)
      {
        most = size;
        strained = i;
      }
    }
    return {finite_ ? .5 * std::log(most) : most, angle.value(), strained, angle.point()};
  }


  SolidIncrementSize SolidMotion::increment_size(const SolidPoints &points, const Vector &du)
  {
    LargestAngle angle;
    for (unsigned int i = 0; i < points.size(); ++i)
      angle.add(points.deformation(du, i / points.per_cell(), i % points.per_cell()).f, i);
    return {0., angle.value(), 0, angle.point()};
  }


  Mandel SolidMotion::strain(const Deformation &F) const
  {
    const auto &f = F.f;
    if (!finite_)
      return {{f[0] - 1., f[3] - 1., F.hoop - 1., root_half * (f[1] + f[2])}};
    return LogarithmicStrain::strain(
      {f[0] * f[0] + f[1] * f[1], f[2] * f[2] + f[3] * f[3], F.hoop * F.hoop, f[0] * f[2] + f[1] * f[3]});
  }


  void SolidMotion::flow_to(const std::size_t point, Mandel e)
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


  Mandel SolidMotion::plastic_strain(const std::size_t point, const Deformation &F) const
  {
    const auto &inverse = plastic_metric_[point];
    Mandel result = LogarithmicStrain::strain({inverse[0], inverse[1], inverse[2], inverse[3]});
    for (double &component : result)
      component = -component;
    return turned(result, F.f);
  }


  void SolidMotion::turn_flow(MaterialPoints &material, const double ratio) const
  {
    // The last flow is known in the axes of the last increment's end: they go on turning.
    // What has axes of its own turns with them.
    if (!finite_ || material.has_axes())
      return;
    for (std::size_t i = 0; i < turns_.size(); ++i)
    {
      const Turn by = times(turns_[i], ratio);
      for (const HistoryField &field : material.law().history_layout().fields())
        if (field.kind == HistoryKind::tensor)
        {
          double *const flow = material.predictor(i) + field.first;
          const Mandel now = by({{flow[0], flow[1], flow[2], flow[3]}});
          std::copy(now.begin(), now.end(), flow);
        }
    }
  }


  void SolidMotion::commit()
  {
    // What becomes trial is overwritten before it is read.
    committed_deformation_.swap(deformation_);
  }


  void SolidMotion::keep()
  {
    committed_deformation_ = deformation_;
  }
} // namespace deltaform
