#include <deltaform/model/next_state.h>

#include <algorithm>

namespace deltaform
{
  double NextState::force_floor() const
  {
    return std::max(1e-13 * model_.blank().stiffness_scale() * typical_length(),
                    1e-6 * model_.committed_state().largest_force);
  }


  Status NextState::assemble(const Vector &q, const bool tangent)
  {
    const ModelTimers &timers = model_.timers();
    System &system = workspace_.system();
    const double time = workspace_.time();
    {
      const Timers::Scope timer(timers.all, timers.clear);
      system.clear(tangent || workspace_.contact().factors_due());
    }
    Status status;
    {
      const Timers::Scope timer(timers.all, timers.body);
      status = model_.body().assemble(q, time, system);
    }
    if (!status.good())
      return status;
    {
      const Timers::Scope timer(timers.all, timers.sum);
      system.sum_over_ranks();
    }

    const Timers::Scope timer(timers.all, timers.contact);
    workspace_.contact().read_body(q, system, tangent);
    status = model_.terms().assemble_others(q, time, system);
    if (!status.good())
      return status;
    if (tangent && !model_.blank().may_be_distributed())
      system.keep();
    if (tangent)
      workspace_.tell_before_contact();
    status = model_.contact_set().assemble(q, time, system);
    if (system.wants_tangent())
      workspace_.contact().remember_set();
    return status;
  }


  bool NextState::assemble_foreseen(const Vector &q)
  {
    const Timers::Scope timer(model_.timers().all, model_.timers().contact);
    if (!workspace_.system().go_back())
      return false;
    return model_.contact_set().assemble(q, workspace_.time(), workspace_.system()).good();
  }


  void NextState::begin(const double time, const double ratio)
  {
    workspace_.begin(time);
    model_.body().begin_increment(time - model_.time(), ratio);
  }
} // namespace deltaform
