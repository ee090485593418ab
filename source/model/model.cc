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
      timer_blank_(timers.section("3-6 blank: strains, material, residual, tangent")),
      timer_sum_(timers.section("6 sum over processes")),
      timer_contact_(timers.section("7-9 contact: projection, forces, tangent")),
      timer_commit_(timers.section("12 commit")), contact_(actors)
  {
    number_unknowns();
    state_.tool_forces.resize(actors_.tools.size());
    state_.travels.resize(actors_.tools.size());
    state_.load_resultants.resize(actors_.loads.size());
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
      state_.travels[i] = actors_.tools[i]->force_driven() ? 0. : actors_.tools[i]->travel(0.);
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
    prescribed_.reinit(n);
    state_.hold.reinit(n);
    state_.released.reset(n, actors_.tools.size(), actors_.supports.size(), actors_.loads.size());
    state_.load_forces.reinit(n);
    state_.reactions.reinit(n);
    is_prescribed_ = numbering_.is_fixed;
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


  double Model::travel(const unsigned int tool) const
  {
    return state_.travels[tool];
  }


  double Model::reaction(const unsigned int support) const
  {
    const Support &which = actors_.supports[support];
    if (!which.acts_in(stage_name_))
      return state_.released.share(time_) * state_.released.of_supports[support];
    double sum = 0.;
    for (const auto dof : which.dofs)
      if (!numbering_.is_fixed[dof])
        sum += state_.reactions[dof];
    return sum;
  }


  bool Model::releases_at_once() const
  {
    return state_.releases_at_once;
  }


  void Model::assemble_loads(const Vector &q, AssemblyTarget &target) const
  {
    for (const auto &load : actors_.loads)
      if (load.acts_in(stage_name_))
        load.assemble(*actors_.blank, q, time_, target);
    state_.released.assemble(time_, target);
  }


  Status Model::assemble(const Vector &q, const bool tangent)
  {
    {
      Timers::Scope timer(timers_, timer_clear_);
      system_->clear(tangent || contact_.factors_due());
    }
    Status status;
    {
      Timers::Scope timer(timers_, timer_blank_);
      status = actors_.blank->assemble(q, *system_);
    }
    if (!status.good())
      return status;
    {
      Timers::Scope timer(timers_, timer_sum_);
      system_->sum_over_ranks();
    }

    Timers::Scope timer(timers_, timer_contact_);
    contact_.predict_factors(q, *system_, tangent);
    assemble_loads(q, *system_);
    if (tangent && before_contact_)
      before_contact_(*system_);
    contact_.assemble(q, *system_, tangent);
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
    prescribed_ = state_.unknowns;
    for (const auto &support : actors_.supports)
      if (support.acts_in(stage_name_))
        for (unsigned int i = 0; i < support.dofs.size(); ++i)
        {
          const DofIndex dof = support.dofs[i];
          prescribed_[dof] = numbering_.is_fixed[dof] ? 0. : (support.hold ? state_.hold[dof] : support.at(i, time));
        }
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
