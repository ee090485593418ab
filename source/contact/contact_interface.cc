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

    double allowed_penetration(const ContactSettings &settings, const ContactInterface &interface, const double time)
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
      iteration_(*settings.normal_law, projector_, factors_, friction_.get()), account_(settings.stores_energy())
  {
    resize();
  }


  void ContactInterface::start_multipliers(Vector &q) const
  {
    normal_law().start(committed_.points, multiplier_dof(0), q);
  }


  void ContactInterface::begin_stage(const Vector &q, const double time)
  {
    committed_.time = trial_.time = time;
    committed_.step = 0.;
    const Tensor1 way = shift(q);
    for (unsigned int i = 0; i < committed_.points.size(); ++i)
    {
      const ContactPoint description = point(q, i);
      committed_.points[i].position = description.x - way;
      committed_.points[i].thickness = description.thickness;
    }
    projector_.discard_distances();
  }


  void ContactInterface::begin_increment(const double time)
  {
    iteration_.begin_increment();
    trial_ = committed_;
    trial_.time = time;
    factors_.begin_increment(time, committed_);
    const double delta = allowed_penetration(settings_, *this, time);
    projector_.find_flat(committed_.points, delta);
    for (auto &state : trial_.points)
    {
      state.delta = delta;
      state.multiplier = state.touching ? state.force : 0.;
    }
    if (friction_)
      friction_->begin_increment(trial_.points);
  }


  void ContactInterface::assemble(const Vector &q, AssemblyTarget &target)
  {
    iteration_.assemble(q, shift(q), trial_.time, committed_.points, trial_.points, target);
  }


  bool ContactInterface::consistent(const double allowed_tension) const
  {
    return std::all_of(trial_.points.begin(), trial_.points.end(), [&](const ContactPointState &state) {
      return normal_law().is_solution(state, allowed_tension, !factors_.softened());
    });
  }


  const double *ContactInterface::set_shifts(const double *next)
  {
    for (auto &state : trial_.points)
      state.shift = *next++;
    return next;
  }


  void ContactInterface::commit(const Vector &q)
  {
    account_.begin(n_points());
    iteration_.complete(q, shift(q), trial_.points);
    for (unsigned int i = 0; i < trial_.points.size(); ++i)
    {
      ContactPointState &state = trial_.points[i];
      const ContactPointState &before = committed_.points[i];
      // The trial states are those of the last assembly.
      Assert(state.position.distance(point(q, i).x - shift(q)) <= 1e-12 * (1. + state.position.norm()),
             dealii::ExcInternalError());
      state.previous_force = before.touching ? before.force : 0.;
      if (!state.touching)
        state.penalty_factor = state.tangential_factor = state.stiffness = state.shift = state.last_penetration = 0.;
      if (!state.touching && !(before.touching && account_.counts()))
        continue;
      const double offset = state.touching ? iteration_.touching_point(i).offset : point(q, i).offset;
      const double slip = friction_ ? friction_->slip_of_increment(i, before, state, offset) : 0.;
      if (friction_ && state.touching && !state.sticking)
        state.slip += std::abs(slip);
      if (!account_.counts())
        continue;
      const Point2 &open = (state.touching ? before : state).position;
      const double open_gap = state.touching != before.touching ? projector_.look(i, open).distance - offset : 0.;
      account_.add(i, before, state, slip, open_gap, trial_.energy);
      if (before.touching && state.touching)
        trial_.energy.thickness += .5 * (before.force + state.force) * (offset - before.offset);
    }
    trial_.step = trial_.time - committed_.time;
    account_.finish(trial_);
    committed_ = trial_;
  }


  void ContactInterface::resize()
  {
    committed_.points.assign(n_points(), ContactPointState());
    trial_.points = committed_.points;
    iteration_.resize(n_points());
    projector_.reset();
  }


  void ContactInterface::transfer(const Vector &q, const std::vector<PointOrigin> &origins)
  {
    const double time = trial_.time;
    committed_.points = transferred_points(committed_.points, origins, shift(q), q, projector_);
    iteration_.resize(n_points());
    account_.renew(committed_);
    trial_ = committed_;
    trial_.time = time;
  }


  void ContactInterface::release(const Vector &q, AssemblyTarget &target)
  {
    release_points(committed_.points, q, projector_, target);
    trial_.points = committed_.points;
    InterfaceAccount::release(committed_.energy);
  }


  void ContactInterface::count_no_energy()
  {
    account_.stop();
    committed_.energy = trial_.energy = ContactEnergy();
  }
} // namespace deltaform
