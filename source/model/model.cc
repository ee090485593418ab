#include <deltaform/model/model.h>

#include <algorithm>

namespace deltaform
{
  Model::Model(Actors &actors, const LinearSolverSettings &linear_solver, Timers &timers)
    : actors_(actors), timers_(timers), discretization_(actors, linear_solver), body_(actors, contact_), stops_(actors),
      contact_(actors), supports_(actors, discretization_.numbering()),
      book_(actors, discretization_.numbering(), supports_, contact_), terms_(body_, contact_),
      formed_start_(actors, body_, supports_, discretization_.numbering(), state_)
  {
    clear_state();
    for (const auto &tool : actors_.tools)
      state_.travels.push_back(tool->travel(0.));
  }


  void Model::clear_state()
  {
    const unsigned int n = discretization_.numbering().n();
    state_.unknowns.reinit(n);
    state_.hold.reinit(n);
    book_.clear(state_);
  }


  double Model::force_floor() const
  {
    return std::max(1e-13 * actors_.blank->stiffness_scale() * typical_length(), 1e-6 * state_.largest_force);
  }


  Status Model::assemble(const Vector &q, const bool tangent)
  {
    {
      const Timers::Scope timer(timers_.all, timers_.clear);
      system().clear(tangent || contact_.factors_due());
    }
    Status status;
    {
      const Timers::Scope timer(timers_.all, timers_.body);
      status = body_.assemble(q, time_, system());
    }
    if (!status.good())
      return status;
    {
      const Timers::Scope timer(timers_.all, timers_.sum);
      system().sum_over_ranks();
    }

    const Timers::Scope timer(timers_.all, timers_.contact);
    terms_.read_body(q, system(), tangent);
    status = terms_.assemble_others(q, time_, system());
    if (!status.good())
      return status;
    if (tangent && !actors_.blank->may_be_distributed())
      system().keep();
    if (tangent && before_contact_)
      before_contact_(system());
    return contact_.assemble(q, time_, system());
  }


  bool Model::assemble_foreseen(const Vector &q)
  {
    const Timers::Scope timer(timers_.all, timers_.contact);
    if (!system().go_back())
      return false;
    for (auto *interface : contact_.interfaces())
      interface->assemble(q, system());
    return true;
  }


  void Model::begin(const double time, const double ratio)
  {
    discard(time);
    body_.begin_increment(time - state_.time, ratio);
  }


  void Model::discard(const double time)
  {
    time_ = time;
    supports_.prescribe(state_, time);
    contact_.begin_increment(time);
    system().discard_factors();
  }
} // namespace deltaform
