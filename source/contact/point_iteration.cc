#include <deltaform/contact/contact_force.h>
#include <deltaform/contact/point_iteration.h>
#include <deltaform/contact/point_rows.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /// Gap of a projected point, with its round-off.
    double gap_of(const Projection &projection, const ContactPoint &point, ContactPointState &state)
    {
      // A blank that just rests on a tool touches it, whatever the last digit says.
      const double size =
        state.position.norm() + point.offset +
        (projection.curvature != 0 ? 1 / std::abs(projection.curvature) : 0.);
      state.noise = 8 * std::numeric_limits<double>::epsilon() * size;
      const double gap = projection.distance - point.offset;
      return gap > 0 && gap < 2 * state.noise ? 0. : gap;
    }
  } // namespace


  PointIteration::PointIteration(const NormalLaw &law,
                                 ContactProjector &projector,
                                 const FactorControl &factors,
                                 const InterfaceFriction *friction)
    : law_(law), projector_(projector), factors_(factors), friction_(friction)
  {
  }


  void PointIteration::restart(const bool at_start)
  {
    projector_.for_near_points([&](const unsigned int i) { work_[i].foreseen.reset(); });
    at_start_ = at_start;
    in_place_ = false;
  }


  void PointIteration::describe(const unsigned int i, const Vector &q)
  {
    projector_.describe(q, i, work_[i].point);
    work_[i].has_row = true;
  }


  void PointIteration::locate(const unsigned int i, const Vector &q)
  {
    projector_.locate(q, i, work_[i].point);
    work_[i].has_row = false;
  }


  void PointIteration::find_row(const unsigned int i, const Vector &q)
  {
    if (!work_[i].has_row)
      describe(i, q);
  }


  void PointIteration::press(const unsigned int i,
                             const Vector &q,
                             const Tensor1 &shift,
                             const Points &committed,
                             Points &trial)
  {
    Work &work = work_[i];
    ContactPointState &state = trial[i];
    if (!in_place_)
    {
      // What was clear will be clear, most often, and its row is not asked for.
      work.is_near ? describe(i, q) : locate(i, q);
      state.set_place(work.point, shift);
    }
    const bool known = in_place_ && work.is_near;
    work.is_near =
      work.point.area > 0 && (work.foreseen || !law_.is_free_when_clear(state) ||
                              !projector_.certainly_clear(i, state.position, work.point.offset));
    if (!work.is_near)
    {
      leave(i, state);
      return;
    }
    find_row(i, q);
    meet(i, known, q, committed, trial);
  }


  void PointIteration::leave(const unsigned int i, ContactPointState &state)
  {
    status_changed_ |= state.touching;
    state.touching = false;
    state.force = state.tangential_force = 0.;
    state.gap = projector_.last_distance(i) - work_[i].point.offset;
  }


  void PointIteration::meet(const unsigned int i,
                            const bool known,
                            const Vector &q,
                            const Points &committed,
                            Points &trial)
  {
    ContactPointState &state = trial[i];
    const ContactPointState &before = committed[i];
    Work &work = work_[i];
    const ContactPoint &point = work.point;
    if (!known)
      work.projection = projector_.project(i, state.position);
    state.gap = gap_of(work.projection, point, state);
    state.arc_length = work.projection.arc_length;
    if ((law_.is_concerned(state) || work.foreseen.value_or(false)) && !(state.stiffness > 0))
    {
      factors_.touch(i, point, work.projection, committed, trial);
      if (friction_)
        friction_->start_slip(i, before, state);
    }
    law_.read_unknown(q, first_multiplier_ + i, state);

    const bool held = at_start_ && before.touching;
    work.normal =
      law_.respond(state,
                   {state.gap, point.compliance, factors_.share(before), work.foreseen, held});
    state.gap = work.normal.gap;
    status_changed_ |= state.touching != work.normal.touching;
    state.touching = work.normal.touching;
    state.force = work.normal.force;
    if (work.normal.touching)
      state.compliance = point.compliance;
  }


  void PointIteration::add(const unsigned int i,
                           const Vector &q,
                           const Points &committed,
                           Points &trial,
                           AssemblyTarget &target)
  {
    const Work &work = work_[i];
    ContactPointState &state = trial[i];
    if (!work.is_near)
    {
      law_.close(q, first_multiplier_ + i, target);
      return;
    }
    const FrictionResponse friction =
      friction_ && state.touching
        ? friction_->respond(i, committed[i], state, work.projection, work.point.offset, work.normal)
        : FrictionResponse();
    state.tangential_force = friction.force;
    state.sticking = friction.sticking;
    if (law_.acts(work.normal))
      add(i, friction, q, state, target);
  }


  void PointIteration::add(const unsigned int i,
                           const FrictionResponse &friction,
                           const Vector &q,
                           ContactPointState &state,
                           AssemblyTarget &target)
  {
    const ContactPoint &point = work_[i].point;
    const Projection &projection = work_[i].projection;
    const NormalResponse &normal = work_[i].normal;
    const ContactForce force(projection, friction_ ? friction_->transfer(projection, point.offset) : SlipTransfer(),
                             normal, friction);
    if (normal.touching)
      force_ -= force.value();
    PointRows rows(point);
    projector_.counterpart().add_columns(rows);
    law_.join(rows, first_multiplier_ + i);
    rows.add_force(force.value());
    rows.copy_residual(state.residual);
    if (target.wants_tangent())
    {
      rows.add_gradient(force.value(), force.gradient(normal.touching ? std::max(state.multiplier, 0.) : 0.));
      if (normal.touching && projector_.moving().is_inside(i))
        projector_.moving().add_gradient(projector_, i, q, projection, std::max(state.multiplier, 0.), rows);
      if (friction_ && friction_->shares())
        pressure_rows_.add(rows, force.by_mean_pressure(),
                           state.multiplier > 0. ? force.normal_force_by_place() / friction_->mean_pressure(i).area
                                                 : Tensor1());
    }
    law_.add_equation(normal, state, point.compliance, force, rows);
    rows.add_to(target, target.wants_tangent());
  }


  Tensor1 PointIteration::motion(const unsigned int i, const Vector &d) const
  {
    return work_[i].point.motion(d, -projector_.counterpart().motion(d));
  }


  bool PointIteration::foresee(const unsigned int i, const Vector &q, const Vector &d, const ContactPointState &state)
  {
    Work &work = work_[i];
    if (work.is_near)
    {
      work.foreseen = law_.foresee(state, work.projection.normal * motion(i, d), work.point.compliance);
      return *work.foreseen != state.touching;
    }
    if (!(state.area > 0))
      return false;
    find_row(i, q);
    if (!(motion(i, d).norm() > state.gap))
      return false;
    // It was not projected. If it may come to the tool it has to be, and is free until that is known.
    work.foreseen = false;
    return true;
  }


  void PointIteration::prepare_step(const unsigned int i,
                                    const Vector &d,
                                    const ContactPointState &before,
                                    const ContactPointState &state)
  {
    Work &work = work_[i];
    work.base_multiplier = state.multiplier;
    const double opening = state.touching ? work.projection.normal * motion(i, d) : 0.;
    work.step_multiplier = law_.estimate(state, opening, factors_.share(before)) - state.multiplier;
  }


  void PointIteration::advance(const unsigned int i, const double factor, ContactPointState &state)
  {
    work_[i].foreseen.reset();
    state.multiplier = work_[i].base_multiplier + factor * work_[i].step_multiplier;
  }


  double PointIteration::clear_way(const unsigned int i, const ContactPointState &state) const
  {
    const Work &work = work_[i];
    if (work.is_near || state.multiplier != 0. || work.base_multiplier != 0. || work.step_multiplier != 0.)
      return -1.;
    return work.point.area > 0 ? projector_.clear_way(i, state.position, work.point.offset)
                               : std::numeric_limits<double>::infinity();
  }


  std::vector<PointIteration::Frame> PointIteration::frames(const Points &trial) const
  {
    std::vector<Frame> result;
    for (unsigned int i = 0; i < trial.size(); ++i)
      if (trial[i].touching)
        result.push_back({work_[i].point.dofs[0], work_[i].point.dofs[1], work_[i].projection.normal});
    return result;
  }
} // namespace deltaform
