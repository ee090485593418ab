#include "elastic_core.h"

#include <algorithm>
#include <cmath>

namespace deltaform
{
  ElasticCore::ElasticCore(const ShellPoints &points, MaterialPoints &material, const bool follows)
    : points_(points), material_(material), follows_(follows && material.plastic()), virgin_(material)
  {
    if (!follows_)
      return;
    set_up();
    VirginMetal::Answer unstrained{};
    virgin_.evaluate(Mandel{}, 0., unstrained);
    elastic_ = unstrained.moduli;
    enough_ = 1e-12 * material.initial_flow_stress() / material.law().young_modulus();
  }


  void ElasticCore::set_up()
  {
    if (!follows_)
      return;
    Ends whole;
    for (unsigned int side = 0; side < 2; ++side)
      whole[side].position = (side == 0 ? -.5 : .5) * points_.thickness();
    ends_.assign(points_.size(), whole);
  }


  bool ElasticCore::move(const unsigned int side,
                         const LayerMotion &motion,
                         const double third_stress,
                         const double limit,
                         End &end) const
  {
    // Flow of the virgin metal over the position is nearly linear outside the core and zero inside: secants through
    // places that flow, halved where one of them lands inside.
    VirginMetal::Answer first{};
    if (!virgin_.evaluate(motion.strain(end.position), third_stress, first).good() || !(first.flow > 0.))
      return false;
    const double inward = side == 0 ? 1. : -1.;
    double outer = end.position, flow = first.flow, inside = limit;
    const auto slope_there = motion.slope(outer);
    double slope = 2. * (std::abs(slope_there[0]) + std::abs(slope_there[1]));
    bool bounded = false; // does the metal at `inside` not flow?
    for (unsigned int i = 0; i < 60 && flow > enough_ && std::abs(inside - outer) > 1e-13 * points_.thickness(); ++i)
    {
      double next = outer + inward * (slope > 0. ? flow / slope : std::abs(inside - outer));
      if (!(inward * (inside - next) > 0.))
        next = bounded ? .5 * (outer + inside) : limit;
      VirginMetal::Answer there{};
      if (!virgin_.evaluate(motion.strain(next), third_stress, there).good())
        return false;
      // Flow against the stress outside is that of the other end: a thin core was jumped over, or there is none.
      if (there.flow > 0. && there.stress[0] * first.stress[0] + there.stress[1] * first.stress[1] > 0.)
      {
        slope = (flow - there.flow) / std::abs(next - outer);
        outer = next;
        flow = there.flow;
      }
      else
      {
        inside = next;
        bounded = true;
        slope *= 1.5;
      }
    }
    end.position = outer;
    return true;
  }


  void ElasticCore::fit(const unsigned int place,
                        const unsigned int side,
                        const LayerMotion &motion,
                        const double third_stress,
                        End &end) const
  {
    // A layer counts the more the farther outside it is: nothing jumps when the core leaves another one. As long as
    // it has left none, a point of virgin metal beside the end tells the slope.
    double sum = 0., jump[2] = {0., 0.};
    const auto add = [&](const double distance, const double weight, const Mandel &plastic) {
      for (unsigned int k = 0; k < 2; ++k)
        jump[k] -= weight * distance * (elastic_[4 * k] * plastic[0] + elastic_[4 * k + 1] * plastic[1]);
      sum += weight * distance * distance;
    };
    const double face = side == 0 ? -1. : 1., beside = .02 * face * points_.thickness();
    VirginMetal::Answer virgin{};
    if (virgin_.evaluate(motion.strain(end.position + beside), third_stress, virgin).good())
      add(beside, .05 * points_.thickness(), virgin.plastic);
    for (unsigned int l = 0; l < points_.n_layers(); ++l)
      if (const double distance = points_.layer_position(l) - end.position; distance * face > 0.)
        add(distance,
            points_.layer_weight(l),
            material_.trial_plastic_strain(static_cast<std::size_t>(place) * points_.n_layers() + l));
    for (unsigned int k = 0; k < 2; ++k)
      end.jump[k] = sum > 0. ? jump[k] / sum : 0.;
  }


  template <typename Visit>
  void ElasticCore::visit(const unsigned int side, const End &end, const Visit &at) const
  {
    if (end.exists == 0. || (end.jump[0] == 0. && end.jump[1] == 0.))
      return;
    const double face = (side == 0 ? -.5 : .5) * points_.thickness();
    const double half = .5 * (face - end.position), middle = .5 * (face + end.position);
    // Gauss, three points: exact for K times any quadratic factor.
    constexpr double root = .77459666924148337704, weights[] = {5. / 9., 8. / 9., 5. / 9.};
    for (unsigned int g = 0; g < 3; ++g)
      at(middle + (static_cast<double>(g) - 1.) * root * half, weights[g] * std::abs(half));
    for (unsigned int l = 0; l < points_.n_layers(); ++l)
      if ((points_.layer_position(l) - end.position) * face > 0.)
        at(points_.layer_position(l), -points_.layer_weight(l));
  }


  void ElasticCore::corrections(const unsigned int place, std::vector<Correction> &result) const
  {
    result.clear();
    for (unsigned int side = 0; side < 2; ++side)
    {
      const End &end = ends_[place][side];
      visit(side, end, [&](const double position, const double weight) {
        Correction correction{position, weight, {}};
        for (unsigned int k = 0; k < 2; ++k)
          correction.stress[k] = end.share * end.jump[k] * (position - end.position);
        result.push_back(correction);
      });
    }
  }


  double ElasticCore::work(const unsigned int place, const Mandel &first, const Mandel &last) const
  {
    const double bottom = points_.layer_position(0);
    const double height = points_.layer_position(points_.n_layers() - 1) - bottom;
    double sum = 0.;
    for (unsigned int side = 0; side < 2; ++side)
    {
      const End &end = ends_[place][side];
      visit(side, end, [&](const double position, const double weight) {
        const double up = (position - bottom) / height;
        for (unsigned int k = 0; k < 2; ++k)
          sum += weight * end.share * end.jump[k] * (position - end.position) * ((1. - up) * first[k] + up * last[k]);
      });
    }
    return sum;
  }


  double ElasticCore::not_reversed(const unsigned int place, const unsigned int side, const End &end) const
  {
    // K is minus the elastic stress of the plastic strain that the core does not have.
    double outside = 0., reversed = 0.;
    const double face = side == 0 ? -1. : 1.;
    for (unsigned int l = 0; l < points_.n_layers(); ++l)
    {
      const double distance = points_.layer_position(l) - end.position;
      if (!(distance * face > 0.))
        continue;
      const std::size_t i = static_cast<std::size_t>(place) * points_.n_layers() + l;
      outside += points_.layer_weight(l);
      const Mandel before = material_.plastic_strain(i), after = material_.trial_plastic_strain(i);
      double along = 0.;
      for (unsigned int k = 0; k < 2; ++k)
        along += (after[k] - before[k]) * end.jump[k] * distance;
      if (along > 0.)
        reversed += points_.layer_weight(l);
    }
    return outside > 0. ? 1. - reversed / outside : 1.;
  }


  void ElasticCore::commit(const unsigned int place, const LayerMotion &motion, const double third_stress)
  {
    Ends &ends = ends_[place];
    if (ends[0].exists == 0.)
      return;
    for (unsigned int side = 0; side < 2; ++side)
      if (End &end = ends[side]; move(side, motion, third_stress, ends[1 - side].position, end))
      {
        fit(place, side, motion, third_stress, end);
        end.share = 1.;
      }
      else
        end.share = std::min(end.share, not_reversed(place, side, end));
    if (ends[1].position - ends[0].position < 1e-9 * points_.thickness())
      for (End &end : ends)
        end.exists = 0.;
  }
} // namespace deltaform
