#include "contact_transfer.h"

#include <deltaform/contact/contact_interface.h>
#include <deltaform/contact/contact_measures.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<InterfaceFriction> make_friction(Section &tool_section, const ContactProjector &projector)
    {
      if (auto law = make_friction_law(tool_section))
        return std::make_unique<InterfaceFriction>(std::move(law), projector);
      return nullptr;
    }

    double delta_at(const ContactSettings &settings, const ContactInterface &interface, const double time)
    {
      const TimeFunction *own = interface.tool().allowed_penetration();
      const double asked = own ? (*own)(time) : settings.allowed_penetration(time);
      return asked < 0 ? -asked * automatic_delta(interface) : asked;
    }
  } // namespace


  ContactInterface::ContactInterface(const ContactSurface &surface,
                                     const Tool &tool,
                                     std::unique_ptr<Counterpart> counterpart,
                                     const ContactSettings &settings,
                                     Section tool_section)
    : settings_(settings), tool_(tool), counterpart_(std::move(counterpart)),
      projector_(surface, tool.side(), *counterpart_, tool_section), friction_(make_friction(tool_section, projector_)),
      factors_(settings, projector_, friction_.get()),
      iteration_(*settings.normal_law, projector_, factors_, friction_.get()), states_(projector_),
      account_(settings.stores_energy())
  {
    resize();
  }


  void ContactInterface::approach(const Vector &q, const Vector *const step)
  {
    const Tensor1 motion = step == nullptr ? Tensor1() : counterpart_->motion(*step);
    for (const unsigned int e : states_.approach(q, step, shift(q), motion))
      iteration_.renew(e);
  }


  void ContactInterface::begin_increment(const Vector &q, const double time)
  {
    for (const unsigned int e : states_.look_at_near(q, counterpart_->way(q, states_.committed.time)))
      iteration_.renew(e);
    iteration_.begin_increment();
    factors_.begin_increment(time, states_.committed);
    states_.begin_increment(time, delta_at(settings_, *this, time));
    if (friction_)
      friction_->begin_increment(states_.trial.points);
  }


  bool ContactInterface::consistent(const double allowed_tension) const
  {
    bool result = true;
    projector_.for_near_points([&](const unsigned int i) {
      result = result && normal_law().is_solution(states_.trial.points[i], allowed_tension, !factors_.softened());
    });
    return result;
  }


  void ContactInterface::commit(const Vector &q)
  {
    account_.begin(n_points());
    const InterfaceState &committed = states_.committed;
    InterfaceState &trial = states_.trial;
    const std::vector<EdgeClearance> far = iteration_.complete(q, shift(q), committed.points, trial.points);
    const Tensor1 way = shift(q);
    projector_.for_near_points([&](const unsigned int i) {
      ContactPointState &state = trial.points[i];
      const ContactPointState &before = committed.points[i];
      state.previous_force = before.touching ? before.force : 0.;
      if (!state.touching)
        state.penalty_factor = state.tangential_factor = state.stiffness = state.shift = state.last_penetration = 0.;
      if (!state.touching && !(before.touching && account_.counts()))
        return;
      // The trial states are those of the last assembly.
      Assert(state.position.distance(point(q, i).x - shift(q)) <= 1e-12 * (1. + state.position.norm()),
             dealii::ExcInternalError());
      const double offset = state.touching ? iteration_.touching_point(i).offset : point(q, i).offset;
      const double slip = friction_ ? friction_->slip_of_increment(i, before, state, offset) : 0.;
      if (friction_ && state.touching && !state.sticking)
        state.slip += std::abs(slip);
      if (account_.counts())
        account_.add({projector_, friction_.get(), i, before, state, way, offset, slip}, q, trial.energy);
    });
    trial.step = trial.time - committed.time;
    account_.finish(projector_, trial);
    states_.accept(q, shift(q), far);
    projector_.moving().accept();
  }


  void ContactInterface::resize()
  {
    states_.resize();
    iteration_.resize(n_points());
    projector_.reset();
  }


  void ContactInterface::transfer(const Vector &q, const std::vector<PointOrigin> &origins)
  {
    const double time = states_.trial.time;
    states_.look_at_far(q, shift(q));
    states_.committed.points = transferred_points(states_.committed.points, origins, shift(q), q, projector_);
    iteration_.resize(n_points());
    account_.renew(projector_, states_.committed);
    states_.trial = states_.committed;
    states_.trial.time = time;
  }


  void ContactInterface::release(const Vector &q, AssemblyTarget &target)
  {
    states_.look_at_far(q, shift(q));
    release_points(states_.committed.points, q, projector_, target);
    states_.trial.points = states_.committed.points;
    InterfaceAccount::release(states_.committed.energy);
  }
} // namespace deltaform
