#include "bead_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace deltaform
{
  BeadLine::Crossing BeadLine::find(const Vector &q) const
  {
    Crossing result;
    for (unsigned int i = 0; i + 1 < nodes_.size(); ++i)
    {
      const double before = r(q, i) - lengths_.place, after = r(q, i + 1) - lengths_.place;
      if ((before > 0.) == (after > 0.) && before != 0. && after != 0.)
        continue;
      Crossing crossing;
      crossing.node = i;
      crossing.span = after - before;
      if (crossing.span == 0.)
        continue;
      crossing.share = -before / crossing.span;
      crossing.arc = nodes_[i + 1].arc - nodes_[i].arc;
      crossing.material = nodes_[i].arc + crossing.share * crossing.arc;
      if (result.node == invalid_index ||
          std::abs(crossing.material - history.material) < std::abs(result.material - history.material))
        result = crossing;
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
    if (const Crossing crossing = find(q); crossing.node != invalid_index)
      history.material = crossing.material;
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
    const Crossing crossing = find(q);
    result.share = 0.;
    if (crossing.node == invalid_index)
      return result;
    result.share = mobilize(crossing.material).share;
    result.path += std::abs(crossing.material - history.material);
    result.material = crossing.material;
    return result;
  }


  void BeadLine::add(const Vector &q, const double force, AssemblyTarget &target) const
  {
    const Crossing crossing = find(q);
    if (crossing.node == invalid_index)
      return;
    const auto [share, slope] = mobilize(crossing.material);
    // Both nodes: weight, its derivative by the share of the second, the derivative of that share by their r.
    const std::array<double, 2> weight{{1. - crossing.share, crossing.share}}, growth{{-1., 1.}};
    const std::array<double, 2> turn{{-weight[0] / crossing.span, -weight[1] / crossing.span}};
    const double along = crossing.span > 0. ? -force : force; // in the residual
    const std::array<DofIndex, 2> dofs{{nodes_[crossing.node].unknown, nodes_[crossing.node + 1].unknown}};
    std::array<double, 2> residual;
    std::array<double, 4> matrix;
    for (unsigned int a = 0; a < 2; ++a)
    {
      residual[a] = along * share * weight[a];
      for (unsigned int b = 0; b < 2; ++b)
        matrix[2 * a + b] = along * (slope * crossing.arc * weight[a] + share * growth[a]) * turn[b];
    }
    target.add(dofs.data(), 2, target.wants_tangent() ? matrix.data() : nullptr, residual.data());
  }
} // namespace deltaform
