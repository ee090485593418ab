#include <deltaform/base/ranks.h>
#include <deltaform/base/text.h>
#include <deltaform/base/timers.h>
#include <deltaform/model/model.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  Model::Model(Actors &actors, const LinearSolverSettings &linear_solver, Timers &timers)
    : actors_(actors), linear_solver_(linear_solver), timers_(timers),
      timer_clear_(timers.section("2 clear matrix and residual")),
      timer_body_(timers.section("3-6 blank: strains, material, residual, tangent")),
      timer_sum_(timers.section("6 sum over processes")),
      timer_contact_(timers.section("7-9 contact: projection, forces, tangent")),
      timer_commit_(timers.section("12 commit")), body_(*actors.blank), contact_(actors), supports_(actors, numbering_),
      book_(actors, numbering_, supports_, contact_), terms_{&body_, &contact_}
  {
    number_unknowns();
    for (const auto &tool : actors_.tools)
      state_.travels.push_back(tool->travel(0.));
  }


  void Model::number_unknowns()
  {
    numbering_ = Numbering(actors_);
    const std::size_t width = front_width(*numbering_.pattern);
    linear_solver_.choose(numbering_.n_sparse, width);
    // Newton's method holds on to the object.
    System system(std::move(*numbering_.pattern), numbering_.n_border, linear_solver_, numbering_.owned);
    if (system_)
      *system_ = std::move(system);
    else
      system_ = std::make_unique<System>(std::move(system));
    numbering_.pattern.reset();

    const unsigned int n = numbering_.n();
    state_.unknowns.reinit(n);
    state_.hold.reinit(n);
    book_.clear(state_);
    supports_.enter_stage(state_.stage);
    if (on_linear_path())
      system_->keep_constant_part(numbering_.contact_unknowns, std::clamp<std::size_t>(width / 2, 100, 600));
    if (on_linear_path() || linear_solver_.iterative())
      system_->set_near_null_space(numbering_.rigid_motions(*actors_.blank));
  }


  double Model::typical_length() const
  {
    return actors_.blank->typical_length();
  }


  double Model::force_floor() const
  {
    const double h = actors_.blank->typical_length();
    return std::max(1e-13 * actors_.blank->stiffness_scale() * h, 1e-6 * state_.largest_force);
  }


  bool Model::releases_at_once() const
  {
    return state_.releases_at_once;
  }


  Status Model::assemble(const Vector &q, const bool tangent)
  {
    {
      const Timers::Scope timer(timers_, timer_clear_);
      system_->clear(tangent || contact_.factors_due());
    }
    Status status;
    {
      const Timers::Scope timer(timers_, timer_body_);
      status = body_.assemble(q, time_, *system_);
    }
    if (!status.good())
      return status;
    {
      const Timers::Scope timer(timers_, timer_sum_);
      system_->sum_over_ranks();
    }

    const Timers::Scope timer(timers_, timer_contact_);
    for (Term *const term : terms_)
      term->read_body(q, *system_, tangent);
    for (Term *const term : terms_)
    {
      if (term == &contact_ && tangent && before_contact_)
        before_contact_(*system_);
      if (term != &body_ && status.good())
        status = term->assemble(q, time_, *system_);
    }
    return status;
  }


  void Model::before_contact(std::function<void(const System &)> action)
  {
    before_contact_ = std::move(action);
  }


  double Model::limit_step(const Vector &q, Vector &d) const
  {
    return std::min(contact_.limit_travels(d, typical_length()), actors_.blank->admissible_step(q, d));
  }


  ActiveSet *Model::active_set()
  {
    return contact_.empty() ? nullptr : &contact_;
  }


  unsigned int Model::correct()
  {
    return contact_.correct();
  }


  void Model::begin(const double time, const double ratio)
  {
    discard(time);
    actors_.blank->begin_increment(time - state_.time, ratio);
  }


  void Model::discard(const double time)
  {
    time_ = time;
    supports_.prescribe(state_, time);
    contact_.begin_increment(time);
    system_->forget_factors();
  }


  IncrementSize Model::increment_size(const Vector &dq) const
  {
    return actors_.blank->increment_size(dq);
  }


  std::string Model::describe(const DofIndex unknown) const
  {
    return unknown < actors_.blank->n_dofs() ? actors_.blank->describe_dof(unknown) : "";
  }


  std::string Model::linear_failure() const
  {
    return system_->linear_failure();
  }


  unsigned int Model::n_linear_iterations() const
  {
    return system_->n_linear_iterations();
  }


  std::string Model::broken_promise() const
  {
    return contact_.broken_promise(state_.unknowns);
  }


  bool Model::soften(const double share)
  {
    return contact_.soften(share);
  }
} // namespace deltaform
