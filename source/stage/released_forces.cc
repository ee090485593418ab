#include <deltaform/stage/released_forces.h>

#include <algorithm>

namespace deltaform
{
  void ReleasedForces::reset(const unsigned int n,
                             const unsigned int n_tools,
                             const unsigned int n_supports,
                             const unsigned int n_loads)
  {
    any = false;
    on_blank.reinit(n);
    of_tools.assign(n_tools, Tensor1());
    of_supports.assign(n_supports, 0.);
    of_loads.assign(n_loads, Tensor1());
    of_earlier_operation = Tensor1();
    pressure = {};
  }


  void ReleasedForces::begin_stage(const Stage &stage)
  {
    begin_ = stage.begin;
    end_ = stage.end;
    at_once_ = stage.release_at_once;
  }


  double ReleasedForces::share(const double time) const
  {
    if (!any || at_once_)
      return 0.;
    return std::max(0., (end_ - time) / (end_ - begin_));
  }


  void ReleasedForces::add(const double time, AssemblyTarget &target) const
  {
    const double now = share(time), zero = 0.;
    if (now == 0.)
      return;
    for (DofIndex i = 0; i < on_blank.size(); ++i)
      if (on_blank[i] != 0.)
      {
        const double residual = -now * on_blank[i];
        target.add(&i, 1, target.wants_tangent() ? &zero : nullptr, &residual);
      }
  }
} // namespace deltaform
