#include <deltaform/assembly/collector.h>

#include <deltaform/contact/contact_measures.h>
#include <deltaform/model/force_book.h>
#include <deltaform/process/ranks.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  ForceBook::ForceBook(const Actors &actors, const Numbering &numbering, const SupportSet &supports,
                       const ContactSet &contact)
    : actors_(actors), numbering_(numbering), supports_(supports), contact_(contact)
  {
  }


  void ForceBook::clear(ModelState &state) const
  {
    const unsigned int n = numbering_.n();
    state.released.reset(n, actors_.tools.size(), actors_.supports.size(), actors_.loads.size());
    state.load_forces.reinit(n);
    state.reactions.reinit(n);
    state.tool_forces.resize(actors_.tools.size());
    state.load_resultants.resize(actors_.loads.size());
  }


  void ForceBook::add_loads(const Vector &q, const ModelState &state, AssemblyTarget &target) const
  {
    for (const auto &load : actors_.loads)
      if (load->acts_in(state.stage))
        load->assemble(q, state.time, target);
    state.released.add(state.time, target);
  }


  void ForceBook::accept(const Vector &q, const System &system, ModelState &state) const
  {
    // Work of loads, of released forces, and of supports, whose reactions are what the residual shows in their rows.
    Collector loads(q.size());
    add_loads(q, state, loads);
    accept_loads(q, state);
    for (unsigned int i = 0; i < q.size(); ++i)
    {
      const bool prescribed = supports_.is_prescribed()[i];
      const double force = prescribed ? system.residual()[i] - loads.residual[i] : -loads.residual[i];
      if (i < numbering_.n_blank)
        state.work.loads += .5 * (force + state.load_forces[i]) * (q[i] - state.unknowns[i]);
      state.load_forces[i] = force;
      state.reactions[i] = prescribed ? system.residual()[i] : 0.;
    }
    accept_tools(q, state);
    remember_largest(system, state);
  }


  void ForceBook::accept_loads(const Vector &q, ModelState &state) const
  {
    const double released = state.released.share(state.time);
    for (unsigned int i = 0; i < actors_.loads.size(); ++i)
    {
      state.load_resultants[i] = released * state.released.of_loads[i];
      if (!actors_.loads[i]->acts_in(state.stage))
        continue;
      Collector own(q.size());
      actors_.loads[i]->assemble(q, state.time, own);
      state.load_resultants[i] = -1. * numbering_.resultant(own.residual);
      // A moment counts by the thickness.
      for (unsigned int k = 0; k < numbering_.n_blank; ++k)
        state.largest_resultant = std::max(state.largest_resultant, std::abs(own.residual[k]) / numbering_.scale[k]);
    }
  }


  void ForceBook::accept_tools(const Vector &q, ModelState &state) const
  {
    const double released = state.released.share(state.time);
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
    {
      const ContactInterface &interface = *actors_.interfaces[i];
      const bool active = contact_.takes_part(interface);
      const Tensor1 force = active ? interface.tool_force() : released * state.released.of_tools[i];
      const double travel = active ? interface.travel(q) : state.travels[i];
      const double way = travel - state.travels[i];
      state.work.tools -= .5 * (force + state.tool_forces[i]) * actors_.tools[i]->direction() * way;
      state.tool_forces[i] = force;
      state.travels[i] = travel;
    }
  }


  double ForceBook::work_of_landing(const Vector &q, const ModelState &state) const
  {
    constexpr double touching = 1e-3; // of the force
    double work = 0.;
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
    {
      const ContactInterface &interface = *actors_.interfaces[i];
      if (!actors_.tools[i]->force_driven() || !contact_.takes_part(interface))
        continue;
      const Tensor1 force = interface.tool_force();
      if (state.tool_forces[i].norm() < touching * force.norm())
        work -= .5 * force * actors_.tools[i]->direction() * (interface.travel(q) - state.travels[i]);
    }
    return std::max(work, 0.);
  }


  void ForceBook::remember_largest(const System &system, ModelState &state) const
  {
    for (const auto *const forces : {&state.tool_forces, &state.load_resultants})
      for (const auto &force : *forces)
        state.largest_resultant = std::max({state.largest_resultant, std::abs(force[0]), std::abs(force[1])});
    for (unsigned int i = 0; i < actors_.supports.size(); ++i)
      if (const Support &support = actors_.supports[i]; !support.dofs.empty())
        state.largest_resultant =
          std::max(state.largest_resultant,
                   std::abs(supports_.reaction(i, state)) / numbering_.scale[support.dofs.front()]);
    double square = 0.;
    for (unsigned int i = 0; i < numbering_.scale.size(); ++i)
      square += std::pow(system.magnitude()[i] / numbering_.scale[i], 2);
    state.largest_force = std::max(state.largest_force, std::sqrt(square));
  }


  void ForceBook::renew_loads(ModelState &state) const
  {
    Collector loads(state.unknowns.size());
    add_loads(state.unknowns, state, loads);
    for (unsigned int i = 0; i < numbering_.n_blank; ++i)
      state.load_forces[i] = supports_.is_prescribed()[i] ? 0. : -loads.residual[i];
  }


  void ForceBook::release(const std::string &next_stage, ModelState &state) const
  {
    begin_loads(next_stage, state);
    const auto ends = [&](const auto &acts_in) { return acts_in(state.stage) && !acts_in(next_stage); };
    Collector ending(state.unknowns.size());
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
      if (ends([&](const std::string &stage) { return actors_.tools[i]->exists_in(stage); }))
      {
        if (actors_.blank->feels_pressure())
          add_contact_pressure(*actors_.interfaces[i], actors_.interfaces[i]->committed(), state.unknowns,
                               state.released.pressure);
        actors_.interfaces[i]->release(state.unknowns, ending);
        state.released.of_tools[i] = state.tool_forces[i];
      }
    // What tools did becomes work of the forces that fade.
    for (unsigned int i = 0; i < numbering_.n_blank; ++i)
      state.load_forces[i] -= ending.residual[i];
    for (unsigned int i = 0; i < actors_.loads.size(); ++i)
      if (ends([&](const std::string &stage) { return actors_.loads[i]->acts_in(stage); }))
      {
        actors_.loads[i]->assemble(state.unknowns, state.time, ending);
        state.released.of_loads[i] = state.load_resultants[i];
      }
    // Reactions of supports that end, each once.
    std::vector<bool> ended(numbering_.n_blank, false);
    for (unsigned int i = 0; i < actors_.supports.size(); ++i)
      if (ends([&](const std::string &stage) { return actors_.supports[i].acts_in(stage); }))
      {
        state.released.of_supports[i] = supports_.reaction(i, state);
        for (const auto dof : actors_.supports[i].dofs)
        {
          if (!ended[dof])
            ending.residual[dof] -= state.reactions[dof];
          ended[dof] = true;
        }
      }
    for (unsigned int i = 0; i < numbering_.n_blank; ++i)
    {
      state.released.on_blank[i] = -ending.residual[i];
      state.released.any |= state.released.on_blank[i] != 0.;
    }
  }


  void ForceBook::begin_loads(const std::string &next_stage, const ModelState &state) const
  {
    for (const auto &load : actors_.loads)
      if (load->acts_in(next_stage) && !load->acts_in(state.stage))
        load->begin(state.unknowns);
  }


  void ForceBook::save_histories(ModelState &state) const
  {
    state.load_histories.clear();
    for (const auto &load : actors_.loads)
      state.load_histories.push_back(load->history());
  }


  void ForceBook::load_histories(const ModelState &state) const
  {
    for (unsigned int i = 0; i < actors_.loads.size(); ++i)
      actors_.loads[i]->set_history(state.load_histories[i]);
  }


  void ForceBook::release_formed(Body &body, const Stage &stage, ModelState &state) const
  {
    for (const auto &load : actors_.loads)
      load->begin(state.unknowns);
    actors_.blank->begin_increment(stage.end - stage.begin, 0.);
    Collector inside(state.unknowns.size());
    if (!body.assemble(state.unknowns, stage.begin, inside).good())
      return;
    if (actors_.blank->may_be_distributed())
      ranks::sum(inside.residual.begin(), inside.residual.size());
    for (unsigned int i = 0; i < numbering_.n_blank; ++i)
      state.released.on_blank[i] = supports_.is_prescribed()[i] ? 0. : inside.residual[i];
  }


  Tensor1 ForceBook::earlier_force(const ModelState &state) const
  {
    return state.released.share(state.time) * state.released.of_earlier_operation;
  }


  double ForceBook::balance_error(const ModelState &state) const
  {
    Tensor1 sum, largest;
    const auto count = [&](const Tensor1 &force) {
      sum += force;
      for (unsigned int d = 0; d < 2; ++d)
        largest[d] = std::max(largest[d], std::abs(force[d]));
    };
    for (const auto &force : state.tool_forces)
      count(-force);
    for (const auto &force : state.load_resultants)
      count(force);
    count(earlier_force(state));
    // An unknown that two supports hold counts once.
    std::vector<bool> counted(numbering_.n_blank, false);
    for (unsigned int i = 0; i < actors_.supports.size(); ++i)
      if (const Component component = actors_.supports[i].component; component != Component::rotation)
      {
        Tensor1 force;
        force[component == Component::r ? 0 : 1] = supports_.uncounted_reaction(i, state, counted);
        count(force);
      }
    const double floor = least_force(state);
    double error = 0.;
    for (unsigned int d = actors_.blank->axisymmetric() ? 1 : 0; d < 2; ++d)
      if (const double size = std::max(largest[d], floor); size > 0.)
        error = std::max(error, std::abs(sum[d]) / size);
    return error;
  }


  double ForceBook::least_force(const ModelState &state) const
  {
    const double round_off = 1e-9 * actors_.blank->stiffness_scale() * actors_.blank->typical_length();
    return std::max(1e-3 * state.largest_resultant, round_off);
  }


  double ForceBook::imbalance(const System &system, const ModelState &state) const
  {
    Tensor1 left, reactions;
    for (DofIndex i = 0; i < numbering_.n_blank; ++i)
      for (unsigned int d = 0; d < 2; ++d)
        (supports_.is_prescribed()[i] ? reactions : left)[d] += numbering_.translation[d][i] * system.residual()[i];
    const double floor = least_force(state);
    double error = 0.;
    for (unsigned int d = actors_.blank->axisymmetric() ? 1 : 0; d < 2; ++d)
    {
      double largest = std::max(floor, std::abs(reactions[d]));
      for (const auto &interface : actors_.interfaces)
        if (contact_.takes_part(*interface))
          largest = std::max(largest, std::abs(interface->tool_force()[d]));
      for (const auto &force : state.load_resultants)
        largest = std::max(largest, std::abs(force[d]));
      error = std::max(error, std::abs(left[d]) / largest);
    }
    return error;
  }
} // namespace deltaform
