// An increment of an interface: how it begins, what its factors are predicted from, how it is accepted.
#include "interface_energy.h"
#include "slip_transfer.h"

#include <deltaform/contact/contact_interface.h>
#include <deltaform/contact/contact_measures.h>
#include <deltaform/geometry/curvature.h>

#include <cmath>

namespace deltaform
{
  void ContactInterface::begin_stage(const Vector &q, const double time)
  {
    committed_.time = trial_.time = time;
    committed_.step = 0.;
    const Tensor1 shift = travel(q) * tool_.direction();
    for (unsigned int i = 0; i < committed_.points.size(); ++i)
    {
      const ContactNode description = node(q, i);
      committed_.points[i].position = description.x - shift;
      committed_.points[i].thickness = description.thickness;
    }
    projector_.forget_distances();
  }


  void ContactInterface::begin_increment(const double time)
  {
    at_start_ = true;
    slack_ = 0.;
    trial_ = committed_;
    trial_.time = time;
    factors_.begin_increment(time, committed_);
    if (friction_)
      friction_->begin_increment(projector_.surface(), tool_.side());
    const TimeFunction *own = tool_.allowed_penetration();
    const double asked = own ? (*own)(time) : settings_.allowed_penetration(time);
    const double delta = asked < 0 ? -asked * automatic_delta(*this) : asked;
    for (auto &state : trial_.points)
    {
      state.delta = delta;
      state.multiplier = state.touching ? state.force : 0.;
    }
  }


  void ContactInterface::read_stiffness(const Vector &q, const StiffnessView &stiffness)
  {
    ContactNode node;
    for (unsigned int i = 0; i < trial_.points.size(); ++i)
    {
      projector_.describe(q, i, node);
      factors_.read_block(i, node, stiffness);
      // Touching points set their stiffness anew when factors are predicted; the others at their first touch.
      trial_.points[i].stiffness = 0.;
    }
  }


  void ContactInterface::add_mismatch(const Vector &q, Vector &direction) const
  {
    const Tensor1 shift = travel(q) * tool_.direction();
    for (unsigned int i = 0; i < trial_.points.size(); ++i)
    {
      const ContactPointState &state = trial_.points[i];
      if (!state.touching)
        continue;
      const ContactNode description = node(q, i);
      const Projection projection = projector_.look(i, description.x - shift);
      // C points into the tool
      for (unsigned int k = 0; k < description.n_dofs; ++k)
        direction[description.dofs[k]] -=
          (description.jacobian[k] * projection.normal) * (state.penetration() - state.delta);
    }
  }


  void ContactInterface::predict_factors(const Vector &q, const Vector *coupling)
  {
    const Tensor1 shift = travel(q) * tool_.direction();
    for (unsigned int i = 0; i < trial_.points.size(); ++i)
    {
      ContactPointState &state = trial_.points[i];
      if (!state.touching)
      {
        if (!committed_.points[i].touching)
          state.penalty_factor = state.tangential_factor = 0.;
        continue;
      }
      const ContactNode description = node(q, i);
      const Projection projection = projector_.look(i, description.x - shift);
      state.area = description.area;
      state.thickness = description.thickness;
      double product = 0.;
      if (coupling)
        for (unsigned int k = 0; k < description.n_dofs; ++k)
          product -= (description.jacobian[k] * projection.normal) * (*coupling)[description.dofs[k]];
      factors_.predict(i, description, projection, product, committed_.points, trial_.points);
    }
  }


  double ContactInterface::slip_of_increment(const Vector &q, const unsigned int i) const
  {
    const ContactPointState &now = trial_.points[i], &before = committed_.points[i];
    if (now.touching)
      return offset_slip(tool_.shape(),
                         before.touching ? before.arc_length : now.slip_start, now.arc_length, work_[i].node.offset);
    // What has let go may be anywhere, also beyond the end of the tool: along the tangent where it was held last.
    const Projection last = projector_.look(i, before.position);
    return slip_transfer(tool_.shape(), node(q, i).offset, last).share *
           ((now.position - before.position) * last.tangent);
  }


  void ContactInterface::commit(const Vector &q)
  {
    IncrementWork work(trial_.energy, settings_.stores_energy());
    for (unsigned int i = 0; i < trial_.points.size(); ++i)
    {
      ContactPointState &state = trial_.points[i];
      const ContactPointState &before = committed_.points[i];
      // The trial states are those of the last assembly.
      Assert(state.position.distance(node(q, i).x - travel(q) * tool_.direction()) <=
               1e-12 * (1. + state.position.norm()),
             dealii::ExcInternalError());
      state.previous_force = before.touching ? before.force : 0.;
      if (!state.touching)
        state.penalty_factor = state.tangential_factor = state.stiffness = state.shift = state.last_penetration = 0.;
      if (!state.touching && !(before.touching && counts_energy_))
        continue;
      const double slip = friction_ ? slip_of_increment(q, i) : 0.;
      if (friction_ && state.touching && !state.sticking)
        state.slip += std::abs(slip);
      if (counts_energy_)
        work.add(before, state, slip);
    }
    trial_.step = trial_.time - committed_.time;
    if (counts_energy_)
    {
      work.finish();
      trial_.energy.stored = stored_energy(trial_.points, settings_.stores_energy());
    }
    committed_ = trial_;
  }


  void ContactInterface::refresh(const Vector &q)
  {
    if (!counts_energy_)
      return;
    // The thickness has changed at fixed positions; the forces stay those of the accepted equilibrium.
    const Tensor1 shift = travel(q) * tool_.direction();
    for (unsigned int i = 0; i < committed_.points.size(); ++i)
    {
      const ContactPointState &state = committed_.points[i];
      if (!state.touching)
        continue;
      const ContactNode description = node(q, i);
      const double gap = projector_.look(i, description.x - shift).distance - face(description, state);
      // The force works on the face that moves towards the tool.
      committed_.energy.thickness += state.force * (state.gap - gap);
    }
  }


  void ContactInterface::forget_energy()
  {
    counts_energy_ = false;
    committed_.energy = trial_.energy = ContactEnergy();
  }
} // namespace deltaform
