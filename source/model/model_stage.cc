// What happens between the increments: stages begin, what has ended fades out, states are accepted.
#include "collector.h"

#include <deltaform/model/model.h>
#include <deltaform/model/tool_placement.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  void Model::collect_released(const std::string &next_stage)
  {
    Collector ending(state_.unknowns.size());
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
      if (actors_.tools[i]->exists_in(stage_name_) && !actors_.tools[i]->exists_in(next_stage))
      {
        actors_.interfaces[i]->release(state_.unknowns, ending);
        state_.released.of_tools[i] = state_.tool_forces[i];
      }
    for (unsigned int i = 0; i < actors_.loads.size(); ++i)
      if (const Load &load = actors_.loads[i]; load.acts_in(stage_name_) && !load.acts_in(next_stage))
      {
        load.assemble(*actors_.blank, state_.unknowns, time_, ending);
        state_.released.of_loads[i] = state_.load_resultants[i];
      }
    // Reactions of supports that end, each once.
    std::vector<bool> ended(actors_.blank->n_dofs(), false);
    for (unsigned int i = 0; i < actors_.supports.size(); ++i)
      if (const Support &support = actors_.supports[i]; support.acts_in(stage_name_) && !support.acts_in(next_stage))
      {
        state_.released.of_supports[i] = reaction(i);
        for (const auto dof : support.dofs)
        {
          if (!ended[dof])
            ending.residual[dof] -= state_.reactions[dof];
          ended[dof] = true;
        }
      }
    for (unsigned int i = 0; i < actors_.blank->n_dofs(); ++i)
    {
      state_.released.on_blank[i] = -ending.residual[i];
      state_.released.any |= state_.released.on_blank[i] != 0.;
    }
  }


  void Model::bring_into_contact(const ContactInterface &pair)
  {
    // A force without resistance has no equilibrium. The distance is Lipschitz: going by the gap never goes too far.
    const double reach = 1e3 * (1. + numbering_.size[0]);
    for (unsigned int step = 0; step < 1000; ++step)
    {
      const double gap = pair.projector().closest(state_.unknowns, state_.unknowns[pair.travel_dof()]).second;
      if (!(gap < reach) || gap <= 1e-12 * numbering_.size[0])
        return;
      state_.unknowns[pair.travel_dof()] += gap;
    }
  }


  std::string Model::misplaced_tool(const Stage &stage) const
  {
    if (stage_name_.empty())
      return "";
    for (const auto &pair : actors_.interfaces)
    {
      const Tool &tool = pair->tool();
      if (tool.exists_in(stage_name_) || !tool.exists_in(stage.name))
        continue;
      // The thickness has changed by forming: a tool that leaves room for the initial one overlaps a little.
      const TimeFunction *own = tool.allowed_penetration();
      const double delta = own ? (*own)(stage.begin) : actors_.contact->allowed_penetration(stage.begin);
      const double tolerance = std::max(.1 * actors_.blank->typical_length(), delta);
      const double travel = tool.force_driven() ? state_.unknowns[pair->travel_dof()] : tool.travel(stage.begin);
      if (const auto wrong = find_misplacement(*actors_.blank, *pair, state_.unknowns, travel, tolerance))
        return wrong->message + " (Tools/" + tool.name() + "/" + wrong->entry + ")";
    }
    return "";
  }


  void Model::begin_stage(const Stage &stage)
  {
    state_.released.reset(state_.unknowns.size(), actors_.tools.size(), actors_.supports.size(), actors_.loads.size());
    if (!stage_name_.empty())
      collect_released(stage.name);
    state_.releases_at_once = state_.released.any && stage.release_at_once;
    enter_stage(stage);
    time_ = state_.time = stage.begin;
    for (auto *pair : contact_.interfaces())
    {
      if (pair->tool().force_driven() && pair->n_touching() == 0)
        bring_into_contact(*pair);
      pair->begin_stage(state_.unknowns, stage.begin);
    }
    for (const auto &support : actors_.supports)
      if (support.acts_in(stage.name))
        for (const auto dof : support.dofs)
          state_.hold[dof] = state_.unknowns[dof];
  }


  void Model::enter_stage(const Stage &stage)
  {
    stage_name_ = stage.name;
    state_.released.begin_stage(stage);
    contact_.enter_stage(stage);
    set_prescribed();
  }


  void Model::set_prescribed()
  {
    is_prescribed_ = numbering_.is_fixed;
    for (const auto &support : actors_.supports)
      if (support.acts_in(stage_name_))
        for (const auto dof : support.dofs)
          is_prescribed_[dof] = true;
    // The travel of a force-driven tool that is absent does not change.
    for (auto &pair : actors_.interfaces)
      if (pair->tool().force_driven() && !pair->tool().exists_in(stage_name_))
        is_prescribed_[pair->travel_dof()] = true;
  }


  void Model::forget_energy()
  {
    energies_wanted_ = false;
    actors_.blank->forget_energy();
    for (auto &pair : actors_.interfaces)
      pair->forget_energy();
  }


  void Model::commit(const Vector &q)
  {
    Timers::Scope timer(timers_, timer_commit_);
    // Work of loads, of released forces, and of supports, whose reactions are what the residual shows in their rows.
    Collector loads(state_.unknowns.size());
    assemble_loads(q, loads);
    const double released = state_.released.share(time_);
    for (unsigned int i = 0; i < actors_.loads.size(); ++i)
    {
      state_.load_resultants[i] = released * state_.released.of_loads[i];
      if (!actors_.loads[i].acts_in(stage_name_))
        continue;
      Collector own(state_.unknowns.size());
      actors_.loads[i].assemble(*actors_.blank, q, time_, own);
      state_.load_resultants[i] = -1. * numbering_.resultant(own.residual);
      // A moment counts by the thickness.
      for (unsigned int k = 0; k < actors_.blank->n_dofs(); ++k)
        state_.largest_resultant = std::max(state_.largest_resultant, std::abs(own.residual[k]) / numbering_.scale[k]);
    }
    for (unsigned int i = 0; i < state_.unknowns.size(); ++i)
    {
      const double force = is_prescribed_[i] ? system_->residual()[i] - loads.residual[i] : -loads.residual[i];
      if (i < actors_.blank->n_dofs())
        state_.work.loads += .5 * (force + state_.load_forces[i]) * (q[i] - state_.unknowns[i]);
      state_.load_forces[i] = force;
      state_.reactions[i] = is_prescribed_[i] ? system_->residual()[i] : 0.;
    }
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
    {
      auto &pair = *actors_.interfaces[i];
      const bool active = contact_.takes_part(pair);
      const Tensor1 force = active ? pair.tool_force() : released * state_.released.of_tools[i];
      const double travel = active ? pair.travel(q) : state_.travels[i];
      const double way = travel - state_.travels[i];
      state_.work.tools -= .5 * (force + state_.tool_forces[i]) * actors_.tools[i]->direction() * way;
      state_.tool_forces[i] = force;
      state_.travels[i] = travel;
      if (actors_.tools[i]->force_driven())
        actors_.tools[i]->set_travel(travel);
    }

    contact_.commit(q);
    actors_.blank->commit(q);
    state_.time = time_;
    state_.unknowns = q;
    state_.releases_at_once = false;

    for (const auto *const forces : {&state_.tool_forces, &state_.load_resultants})
      for (const auto &force : *forces)
        state_.largest_resultant = std::max({state_.largest_resultant, std::abs(force[0]), std::abs(force[1])});
    for (unsigned int i = 0; i < actors_.supports.size(); ++i)
      if (const Support &support = actors_.supports[i]; !support.dofs.empty())
        state_.largest_resultant =
          std::max(state_.largest_resultant, std::abs(reaction(i)) / numbering_.scale[support.dofs.front()]);

    double square = 0.;
    for (unsigned int i = 0; i < numbering_.scale.size(); ++i)
      square += std::pow(system_->magnitude()[i] / numbering_.scale[i], 2);
    state_.largest_force = std::max(state_.largest_force, std::sqrt(square));

    contact_.refresh(q);
  }
} // namespace deltaform
