#include <deltaform/assembly/collector.h>

#include <deltaform/loads/arc_length.h>
#include <deltaform/loads/load.h>
#include <deltaform/loads/load_way.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  ArcLength::ArcLength(const Blank &blank)
    : blank_(blank), n_(blank.n_dofs()), n_nodes_(static_cast<double>(blank.positions(Vector(n_)).size())), start_(n_),
      direction_(n_)
  {
  }


  void ArcLength::begin(const Vector &q)
  {
    std::copy_n(q.begin(), n_, start_.begin());
  }


  double ArcLength::weight(const DofIndex unknown) const
  {
    const double scale = blank_.dof_scale(unknown);
    return scale * scale / n_nodes_;
  }


  std::pair<Vector, double> ArcLength::travelled(const Load &load, const Vector &q) const
  {
    Vector gradient(q.size());
    if (direction_.all_zero())
    {
      Vector from(q.size());
      std::copy(start_.begin(), start_.end(), from.begin());
      const LoadWay way(load, q);
      const double forces = load.unit_force(q.size());
      gradient.equ(1. / forces, way.gradient());
      return {gradient, (way.value() - LoadWay(load, from).value()) / forces};
    }
    double length = 0.;
    for (DofIndex i = 0; i < n_; ++i)
    {
      gradient[i] = weight(i) * direction_[i];
      length += gradient[i] * (q[i] - start_[i]);
    }
    return {gradient, length};
  }


  void ArcLength::assemble(const Load &load, const Vector &q, const double length, AssemblyTarget &target) const
  {
    // In the unit of a work, as the other rows are forces times displacements.
    const double forces = load.unit_force(q.size());
    const auto [gradient, travelled] = this->travelled(load, q);
    const double missing = forces * (length - accepted_ - travelled), zero = 0.;
    const DofIndex size = load.unknown();
    target.add(&size, 1, target.wants_tangent() ? &zero : nullptr, &missing);
    if (!target.wants_tangent())
      return;
    Collector unit(q.size());
    load.add(q, 1., unit);
    for (DofIndex i = 0; i < n_; ++i)
      if (unit.residual[i] != 0. || gradient[i] != 0.)
      {
        const DofIndex dofs[] = {i, size};
        const double matrix[] = {0., unit.residual[i], -forces * gradient[i], 0.}, none[] = {0., 0.};
        target.add(dofs, 2, matrix, none);
      }
  }


  void ArcLength::accept(const Vector &q, const double length)
  {
    double sum = 0.;
    Vector way(n_);
    for (DofIndex i = 0; i < n_; ++i)
    {
      way[i] = q[i] - start_[i];
      sum += weight(i) * way[i] * way[i];
      start_[i] = q[i];
    }
    // Forwards is where the length grows.
    if (sum > 0.)
      direction_.equ((length < accepted_ ? -1. : 1.) / std::sqrt(sum), way);
    accepted_ = length;
  }


  std::vector<double> ArcLength::history() const
  {
    std::vector<double> result{accepted_};
    result.insert(result.end(), start_.begin(), start_.end());
    result.insert(result.end(), direction_.begin(), direction_.end());
    return result;
  }


  void ArcLength::set_history(const std::vector<double> &values)
  {
    accepted_ = values[0];
    std::copy_n(values.begin() + 1, n_, start_.begin());
    std::copy_n(values.begin() + 1 + n_, n_, direction_.begin());
  }
} // namespace deltaform
