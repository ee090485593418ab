// What happens between the increments: stages begin, what has ended fades out, states are accepted.
#include "collector.h"

#include <deltaform/contact/contact_measures.h>
#include <deltaform/scene/forming_problem.h>
#include <deltaform/scene/tool_placement.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  void FormingProblem::collect_released(const std::string &next_stage)
  {
    Collector ending(committed_.size());
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
      if (actors_.tools[i]->exists_in(stage_name_) && !actors_.tools[i]->exists_in(next_stage))
      {
        actors_.pairs[i]->release(committed_, ending);
        released_.of_tools[i] = tool_forces_[i];
      }
    for (unsigned int i = 0; i < actors_.loads.size(); ++i)
      if (const Load &load = actors_.loads[i]; load.acts_in(stage_name_) && !load.acts_in(next_stage))
      {
        load.assemble(*actors_.blank, committed_, time_, ending);
        released_.of_loads[i] = load_resultants_[i];
      }
    // Reactions of supports that end, each once.
    std::vector<bool> ended(actors_.blank->n_dofs(), false);
    for (unsigned int i = 0; i < actors_.supports.size(); ++i)
      if (const Support &support = actors_.supports[i]; support.acts_in(stage_name_) && !support.acts_in(next_stage))
      {
        released_.of_supports[i] = reaction(i);
        for (const auto dof : support.dofs)
        {
          if (!ended[dof])
            ending.residual[dof] -= reactions_[dof];
          ended[dof] = true;
        }
      }
    for (unsigned int i = 0; i < actors_.blank->n_dofs(); ++i)
    {
      released_.on_blank[i] = -ending.residual[i];
      released_.any |= released_.on_blank[i] != 0.;
    }
  }


  void FormingProblem::bring_into_contact(const ContactInterface &pair)
  {
    // A force without resistance has no equilibrium. The distance is Lipschitz: going by the gap never goes too far.
    const double reach = 1e3 * (1. + size_[0]);
    for (unsigned int step = 0; step < 1000; ++step)
    {
      const double gap = pair.projector().closest(committed_, committed_[pair.travel_dof()]).second;
      if (!(gap < reach) || gap <= 1e-12 * size_[0])
        return;
      committed_[pair.travel_dof()] += gap;
    }
  }


  std::string FormingProblem::misplaced_tool(const Stage &stage) const
  {
    if (stage_name_.empty())
      return "";
    for (const auto &pair : actors_.pairs)
    {
      const Tool &tool = pair->tool();
      if (tool.exists_in(stage_name_) || !tool.exists_in(stage.name))
        continue;
      // The thickness has changed by forming: a tool that leaves room for the initial one overlaps a little.
      const TimeFunction *own = tool.allowed_penetration();
      const double delta = own ? (*own)(stage.begin) : actors_.contact->allowed_penetration(stage.begin);
      const double tolerance = std::max(.1 * actors_.blank->typical_length(), delta);
      const double travel = tool.force_driven() ? committed_[pair->travel_dof()] : tool.travel(stage.begin);
      if (const auto wrong = find_misplacement(*actors_.blank, *pair, committed_, travel, tolerance))
        return wrong->message + " (Tools/" + tool.name() + "/" + wrong->entry + ")";
    }
    return "";
  }


  void FormingProblem::begin_stage(const Stage &stage)
  {
    released_.reset(committed_.size(), actors_.tools.size(), actors_.supports.size(), actors_.loads.size());
    if (!stage_name_.empty())
      collect_released(stage.name);
    at_once_ = released_.any && stage.release_at_once;
    enter_stage(stage);
    time_ = stage.begin;
    for (auto *pair : active_pairs_)
    {
      if (pair->tool().force_driven() && pair->n_touching() == 0)
        bring_into_contact(*pair);
      pair->begin_stage(committed_, stage.begin);
    }
    for (const auto &support : actors_.supports)
      if (support.acts_in(stage.name))
        for (const auto dof : support.dofs)
          hold_[dof] = committed_[dof];
  }


  void FormingProblem::enter_stage(const Stage &stage)
  {
    stage_name_ = stage.name;
    released_.begin_stage(stage);
    active_pairs_.clear();
    for (auto &pair : actors_.pairs)
      if (pair->tool().exists_in(stage.name))
        active_pairs_.push_back(pair.get());
    set_prescribed();
  }


  void FormingProblem::set_prescribed()
  {
    is_prescribed_ = is_fixed_;
    for (const auto &support : actors_.supports)
      if (support.acts_in(stage_name_))
        for (const auto dof : support.dofs)
          is_prescribed_[dof] = true;
    // The travel of a force-driven tool that is absent does not change.
    for (auto &pair : actors_.pairs)
      if (pair->tool().force_driven() && !pair->tool().exists_in(stage_name_))
        is_prescribed_[pair->travel_dof()] = true;
  }


  void FormingProblem::forget_energy()
  {
    actors_.blank->forget_energy();
    for (auto &pair : actors_.pairs)
      pair->forget_energy();
  }


  void FormingProblem::commit(const Vector &q)
  {
    Timers::Scope timer(timers_, timer_commit_);
    // Work of loads, of released forces, and of supports, whose reactions are what the residual shows in their rows.
    Collector loads(committed_.size());
    assemble_loads(q, loads);
    const double released = released_.share(time_);
    for (unsigned int i = 0; i < actors_.loads.size(); ++i)
    {
      load_resultants_[i] = released * released_.of_loads[i];
      if (!actors_.loads[i].acts_in(stage_name_))
        continue;
      Collector own(committed_.size());
      actors_.loads[i].assemble(*actors_.blank, q, time_, own);
      load_resultants_[i] = -1. * resultant(own.residual);
      // A moment counts by the thickness.
      for (unsigned int k = 0; k < actors_.blank->n_dofs(); ++k)
        largest_resultant_ = std::max(largest_resultant_, std::abs(own.residual[k]) / scale_[k]);
    }
    for (unsigned int i = 0; i < committed_.size(); ++i)
    {
      const double force = is_prescribed_[i] ? system_->residual()[i] - loads.residual[i] : -loads.residual[i];
      if (i < actors_.blank->n_dofs())
        work_.loads += .5 * (force + load_forces_[i]) * (q[i] - committed_[i]);
      load_forces_[i] = force;
      reactions_[i] = is_prescribed_[i] ? system_->residual()[i] : 0.;
    }
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
    {
      auto &pair = *actors_.pairs[i];
      const bool active = std::find(active_pairs_.begin(), active_pairs_.end(), &pair) != active_pairs_.end();
      const Tensor1 force = active ? pair.tool_force() : released * released_.of_tools[i];
      const double travel = active ? pair.travel(q) : travels_[i];
      work_.tools -= .5 * (force + tool_forces_[i]) * actors_.tools[i]->direction() * (travel - travels_[i]);
      tool_forces_[i] = force;
      travels_[i] = travel;
      if (actors_.tools[i]->force_driven())
        actors_.tools[i]->set_travel(travel);
    }

    for (auto *pair : active_pairs_)
      pair->commit(q);
    actors_.blank->commit(q);
    committed_ = q;
    at_once_ = false;

    for (const auto *const forces : {&tool_forces_, &load_resultants_})
      for (const auto &force : *forces)
        largest_resultant_ = std::max({largest_resultant_, std::abs(force[0]), std::abs(force[1])});
    for (unsigned int i = 0; i < actors_.supports.size(); ++i)
      if (const Support &support = actors_.supports[i]; !support.dofs.empty())
        largest_resultant_ = std::max(largest_resultant_, std::abs(reaction(i)) / scale_[support.dofs.front()]);

    double square = 0.;
    for (unsigned int i = 0; i < scale_.size(); ++i)
      square += std::pow(system_->magnitude()[i] / scale_[i], 2);
    largest_force_ = std::max(largest_force_, std::sqrt(square));

    // The thickness has changed: new gaps, and the contact pressure that the next increments see.
    std::array<std::vector<double>, 2> pressure;
    for (auto *pair : active_pairs_)
    {
      pair->refresh(q);
      const auto own = contact_pressure(*pair, q);
      auto &side = pressure[static_cast<unsigned int>(pair->tool().side())];
      if (side.empty())
        side = own;
      else
        for (unsigned int i = 0; i < own.size(); ++i)
          side[i] += own[i];
    }
    // A side that all tools have left is free of pressure.
    for (const Side side : {Side::bottom, Side::top})
    {
      auto &own = pressure[static_cast<unsigned int>(side)];
      if (!actors_.pairs.empty())
      {
        own.resize(actors_.blank->n_contact_nodes(side), 0.);
        actors_.blank->set_contact_pressure(side, own);
      }
    }
  }
} // namespace deltaform
