#include "bead_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace deltaform
{
  BeadLine::Foot BeadLine::find(const Vector &q) const
  {
    Foot result;
    for (unsigned int i = 0; i + 1 < nodes_.size(); ++i)
    {
      const double before = r(q, i) - lengths_.place, behind = r(q, i + 1) - lengths_.place;
      if ((before > 0.) == (behind > 0.) && before != 0. && behind != 0.)
        continue;
      Foot foot;
      foot.node = i;
      foot.span = behind - before;
      if (foot.span == 0.)
        continue;
      foot.share = -before / foot.span;
      foot.arc = nodes_[i + 1].arc - nodes_[i].arc;
      foot.material = nodes_[i].arc + foot.share * foot.arc;
      if (result.node == invalid_index ||
          std::abs(foot.material - history.material) < std::abs(result.material - history.material))
        result = foot;
    }
    return result;
  }


  bool BeadLine::passes(const Vector &q) const
  {
    return find(q).node != invalid_index;
  }


  void BeadLine::begin(const Vector &q)
  {
    history = BeadHistory();
    history.material = nodes_.back().arc; // a sheet that crosses the place more than once is held in its flange
    if (const Foot foot = find(q); foot.node != invalid_index)
      history.material = foot.material;
  }


  BeadLine::Mobilized BeadLine::mobilize(const double material) const
  {
    const double passed = material - history.material, length = lengths_.length;
    const double trial = history.share + passed / lengths_.elastic_slip, sign = trial > 0. ? 1. : -1.;
    const double path = (history.path + std::abs(passed)) / length;
    const double rest = (sign > 0. ? nodes_.back().arc - material : material - nodes_.front().arc) / length;
    const double closed = std::min(path, 1.), covered = std::min(std::max(rest, 0.), 1.), limit = closed * covered;
    if (std::abs(trial) <= limit)
      return {trial, 1. / lengths_.elastic_slip};
    const double closing = path < 1. ? (passed < 0. ? -1. : 1.) / length : 0.;
    const double leaving = rest < 1. && rest > 0. ? -sign / length : 0.;
    return {sign * limit, sign * (closing * covered + closed * leaving)};
  }


  BeadHistory BeadLine::next(const Vector &q) const
  {
    BeadHistory result = history;
    const Foot foot = find(q);
    result.share = 0.;
    if (foot.node == invalid_index)
      return result;
    result.share = mobilize(foot.material).share;
    result.path += std::abs(foot.material - history.material);
    result.material = foot.material;
    return result;
  }


  void BeadLine::add(const Vector &q, const double force, AssemblyTarget &target) const
  {
    const Foot foot = find(q);
    if (foot.node == invalid_index)
      return;
    const auto [share, slope] = mobilize(foot.material);
    // Both nodes: weight, its derivative by the share of the second, the derivative of that share by their r.
    const std::array<double, 2> weight{{1. - foot.share, foot.share}}, growth{{-1., 1.}};
    const std::array<double, 2> turn{{-weight[0] / foot.span, -weight[1] / foot.span}};
    const double along = foot.span > 0. ? -force : force; // in the residual
    const std::array<DofIndex, 2> dofs{{nodes_[foot.node].unknown, nodes_[foot.node + 1].unknown}};
    std::array<double, 2> residual;
    std::array<double, 4> matrix;
    for (unsigned int a = 0; a < 2; ++a)
    {
      residual[a] = along * share * weight[a];
      for (unsigned int b = 0; b < 2; ++b)
        matrix[2 * a + b] = along * (slope * foot.arc * weight[a] + share * growth[a]) * turn[b];
    }
    target.add(dofs.data(), 2, target.wants_tangent() ? matrix.data() : nullptr, residual.data());
  }
} // namespace deltaform
