#include <deltaform/base/ranks.h>
#include <deltaform/base/text.h>
#include <deltaform/base/timers.h>
#include <deltaform/model/forming_problem.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  double FormingProblem::typical_length() const
  {
    return actors_.blank->typical_length();
  }


  double FormingProblem::force_floor() const
  {
    const double h = actors_.blank->typical_length();
    return std::max(1e-13 * actors_.blank->stiffness_scale() * h, 1e-6 * state_.largest_force);
  }


  double FormingProblem::travel(const unsigned int tool) const
  {
    return state_.travels[tool];
  }


  double FormingProblem::reaction(const unsigned int support) const
  {
    const Support &which = actors_.supports[support];
    if (!which.acts_in(stage_name_))
      return state_.released.share(time_) * state_.released.of_supports[support];
    double sum = 0.;
    for (const auto dof : which.dofs)
      if (!is_fixed_[dof])
        sum += state_.reactions[dof];
    return sum;
  }


  Tensor1 FormingProblem::resultant(const Vector &forces) const
  {
    Tensor1 sum;
    for (DofIndex i = 0; i < actors_.blank->n_dofs(); ++i)
      for (unsigned int d = 0; d < 2; ++d)
        sum[d] += translation_[d][i] * forces[i];
    return sum;
  }


  double FormingProblem::balance_error() const
  {
    Tensor1 sum, largest;
    const auto count = [&](const Tensor1 &force) {
      sum += force;
      for (unsigned int d = 0; d < 2; ++d)
        largest[d] = std::max(largest[d], std::abs(force[d]));
    };
    for (const auto &force : state_.tool_forces)
      count(-force);
    for (const auto &force : state_.load_resultants)
      count(force);
    // An unknown that two supports hold counts once.
    std::vector<bool> counted(actors_.blank->n_dofs(), false);
    for (unsigned int i = 0; i < actors_.supports.size(); ++i)
    {
      const Support &support = actors_.supports[i];
      if (support.component == Component::rotation)
        continue;
      const unsigned int d = support.component == Component::r ? 0 : 1;
      Tensor1 force;
      if (support.acts_in(stage_name_))
        for (const auto dof : support.dofs)
        {
          if (!counted[dof] && !is_fixed_[dof])
            force[d] += state_.reactions[dof];
          counted[dof] = true;
        }
      else
        force[d] = reaction(i);
      count(force);
    }
    // What is left of much larger forces is round-off.
    const double floor = 1e-3 * state_.largest_resultant;
    double error = 0.;
    for (unsigned int d = actors_.blank->axisymmetric() ? 1 : 0; d < 2; ++d)
      if (const double size = std::max(largest[d], floor); size > 0.)
        error = std::max(error, std::abs(sum[d]) / size);
    return error;
  }


  bool FormingProblem::releases_at_once() const
  {
    return state_.releases_at_once;
  }


  void FormingProblem::assemble_loads(const Vector &q, AssemblyTarget &target) const
  {
    for (const auto &load : actors_.loads)
      if (load.acts_in(stage_name_))
        load.assemble(*actors_.blank, q, time_, target);
    state_.released.assemble(time_, target);
  }


  Status FormingProblem::assemble(const Vector &q, const bool tangent)
  {
    const bool predict = factors_due_;
    {
      Timers::Scope timer(timers_, timer_clear_);
      system_->clear(tangent || predict);
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
    const bool every_iteration = actors_.contact && actors_.contact->rule->in_every_iteration() && tangent;
    if (predict || every_iteration)
    {
      if (predict)
        for (auto *pair : active_pairs_)
          pair->read_stiffness(q, *system_);
      Vector coupling;
      if (actors_.contact && actors_.contact->enforcement->uses_penalty() && actors_.contact->rule->needs_coupling())
      {
        Vector mismatch(state_.unknowns.size());
        coupling.reinit(state_.unknowns.size());
        for (const auto *pair : active_pairs_)
          pair->add_mismatch(q, mismatch);
        system_->multiply(mismatch, coupling);
      }
      for (auto *pair : active_pairs_)
        pair->predict_factors(q, coupling.size() > 0 ? &coupling : nullptr);
      factors_due_ = false;
    }
    assemble_loads(q, *system_);
    if (tangent && before_contact_)
      before_contact_(*system_);
    for (auto *pair : active_pairs_)
      pair->assemble(q, *system_);
    if (tangent && changed())
    {
      std::size_t signature = 0;
      for (const auto *pair : active_pairs_)
        for (const auto &state : pair->trial())
          boost::hash_combine(signature, state.touching);
      cycling_ |= std::find(visited_.begin(), visited_.end(), signature) != visited_.end();
      visited_.push_back(signature);
    }
    return status;
  }


  void FormingProblem::before_contact(std::function<void(const System &)> action)
  {
    before_contact_ = std::move(action);
  }


  double FormingProblem::limit_step(const Vector &q, Vector &d) const
  {
    double factor = 1.;
    for (const auto *pair : active_pairs_)
      if (pair->tool().force_driven())
      {
        // A tool that has lost contact for a moment goes back to the blank, on its own: were the whole step shortened
        // by what this component is too long, the blank would hardly move.
        double &travel = d[pair->travel_dof()];
        const double closest = pair->free_travel();
        if (closest > 0)
          travel = std::clamp(travel, -std::min(closest, typical_length()), std::min(closest, typical_length()));
        factor = std::min(factor, typical_length() / std::max(std::abs(travel), 1e-300));
      }
    return std::min(factor, actors_.blank->admissible_step(q, d));
  }


  ActiveSet *FormingProblem::active_set()
  {
    return active_pairs_.empty() ? nullptr : this;
  }


  void FormingProblem::prepare_step(const Vector &d)
  {
    for (auto *pair : active_pairs_)
      pair->prepare_step(d);
  }


  void FormingProblem::advance(const double factor)
  {
    for (auto *pair : active_pairs_)
      pair->advance(factor);
  }


  bool FormingProblem::changed() const
  {
    return std::any_of(
      active_pairs_.begin(), active_pairs_.end(), [](const ContactInterface *pair) { return pair->status_changed(); });
  }


  unsigned int FormingProblem::patience() const
  {
    // The same set for the second time: the iteration goes round in circles.
    if (cycling_)
      return 0;
    // Measured on the cup: penalty needs the line search on fine meshes (400 elements: 5698 iterations with patience 2,
    // 10388 with 6), the active set is best left alone (925 iterations; 2564 with patience 2).
    return actors_.contact && actors_.contact->enforcement->has_multiplier() ? 1000 : 2;
  }


  bool FormingProblem::consistent(const double allowed_tension) const
  {
    return std::all_of(active_pairs_.begin(),
                       active_pairs_.end(),
                       [&](const ContactInterface *pair) { return pair->consistent(allowed_tension); });
  }


  unsigned int FormingProblem::correct()
  {
    cycling_ = false;
    visited_.clear();
    unsigned int changed = 0;
    for (auto *pair : active_pairs_)
      changed += pair->correct_factors();
    if (actors_.contact && actors_.contact->enforcement->augmentation_tolerance() > 0)
      changed += augmentation_.update(active_pairs_);
    return changed;
  }


  void FormingProblem::begin(const double time, const double ratio)
  {
    discard(time);
    actors_.blank->begin_increment(ratio);
  }


  void FormingProblem::discard(const double time)
  {
    time_ = time;
    prescribed_ = state_.unknowns;
    for (const auto &support : actors_.supports)
      if (support.acts_in(stage_name_))
        for (unsigned int i = 0; i < support.dofs.size(); ++i)
        {
          const DofIndex dof = support.dofs[i];
          prescribed_[dof] = is_fixed_[dof] ? 0. : (support.hold ? state_.hold[dof] : support.at(i, time));
        }
    for (auto *pair : active_pairs_)
      pair->begin_increment(time);
    augmentation_.restart();
    factors_due_ = !active_pairs_.empty();
    cycling_ = false;
    visited_.clear();
    system_->forget_factors();
  }


  IncrementSize FormingProblem::increment_size(const Vector &dq) const
  {
    return actors_.blank->increment_size(dq);
  }


  std::string FormingProblem::describe(const DofIndex unknown) const
  {
    return unknown < actors_.blank->n_dofs() ? actors_.blank->describe_dof(unknown) : "";
  }


  std::string FormingProblem::linear_failure() const
  {
    return system_->linear_failure();
  }


  unsigned int FormingProblem::n_linear_iterations() const
  {
    return system_->n_linear_iterations();
  }


  std::string FormingProblem::broken_promise() const
  {
    if (!actors_.contact || !actors_.contact->enforcement->uses_penalty() || !actors_.contact->rule->promises())
      return "";
    for (const auto *pair : active_pairs_)
    {
      const auto [i, ratio] = pair->broken_promise();
      if (i == invalid_index)
        continue;
      const ContactPointState &state = pair->trial()[i];
      const ContactNode node = pair->node(state_.unknowns, i);
      std::string text = "the promise p <= delta cannot be kept: tool '" + pair->tool().name() + "', node " +
                         std::to_string(i) + " (R0 = " + text::format(node.reference_coordinate) + ") penetrates " +
                         text::format(state.penetration()) + ", " + text::format(ratio) + " times the allowed " +
                         text::format(state.delta) + ", with penalty factor " + text::format(state.penalty_factor);
      for (const auto *other : active_pairs_)
        if (other->tool().side() != pair->tool().side() && i < other->n_nodes() && other->trial()[i].touching &&
            other->node(state_.unknowns, i).node == node.node)
          text += ". The node is clamped between '" + pair->tool().name() + "' and '" + other->tool().name() +
                  "': its thickness is " + text::format(node.thickness) + ", the gap leaves " +
                  text::format(node.thickness + state.gap + other->trial()[i].gap) +
                  ". Use Contact thickness = initial for the tool with the fixed gap, a wider gap, or a force";
      return text;
    }
    return "";
  }


  void FormingProblem::allow_slack(const double force)
  {
    for (auto *pair : active_pairs_)
      pair->allow_slack(force);
  }


  bool FormingProblem::soften(const double share)
  {
    for (auto *pair : active_pairs_)
      pair->soften(share);
    return !active_pairs_.empty();
  }
} // namespace deltaform
