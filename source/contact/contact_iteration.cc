#include <deltaform/contact/contact_force.h>
#include <deltaform/contact/contact_iteration.h>
#include <deltaform/contact/point_rows.h>

#include <boost/functional/hash.hpp>

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


  ContactIteration::ContactIteration(const NormalLaw &law,
                                     ContactProjector &projector,
                                     const FactorControl &factors,
                                     const InterfaceFriction *friction)
    : law_(law), projector_(projector), factors_(factors), friction_(friction), clear_(projector)
  {
  }


  void ContactIteration::resize(const unsigned int n_points)
  {
    work_.assign(n_points, Work());
    edges_.assign(projector_.group() > 1 ? n_points / projector_.group() : 0, Edge());
  }


  void ContactIteration::restart()
  {
    for (auto &work : work_)
      work.foreseen.reset();
    discard_rows();
    clear_.restart(!law_.has_multiplier());
    at_start_ = in_place_ = false;
  }


  void ContactIteration::discard_rows()
  {
    for (auto &edge : edges_)
      edge.known = false;
  }


  void ContactIteration::assemble(const Vector &q,
                                  const Tensor1 &shift,
                                  const double time,
                                  const Points &committed,
                                  Points &trial,
                                  AssemblyTarget &target)
  {
    tool_force_ = Tensor1();
    status_changed_ = false;
    projector_.counterpart().add_load(q, time, target);
    if (edges_.empty())
      for (unsigned int i = 0; i < trial.size(); ++i)
        assemble(i, q, shift, committed, trial, target);
    Tensor1 force = tool_force_;
    for (unsigned int e = 0; e < edges_.size(); ++e)
    {
      Edge &edge = edges_[e];
      edge.known &= in_place_ && edge.rows.wants_tangent() == target.wants_tangent();
      // In place foresee() has looked at the clear ones.
      if (in_place_ ? clear_.known(e) : clear_.clear(e, q, nullptr, shift))
        continue;
      if (!edge.known)
      {
        assemble_edge(e, q, shift, committed, trial, target.wants_tangent());
        find_clear(e, q, shift, trial);
      }
      edge.rows.add_to(target);
      force += edge.tool_force;
    }
    tool_force_ = force;
  }


  void ContactIteration::assemble_edge(const unsigned int e,
                                       const Vector &q,
                                       const Tensor1 &shift,
                                       const Points &committed,
                                       Points &trial,
                                       const bool tangent)
  {
    Edge &edge = edges_[e];
    edge.rows.begin(tangent);
    edge.touching = 0;
    tool_force_ = Tensor1();
    const unsigned int n = projector_.group();
    for (unsigned int i = e * n; i < (e + 1) * n; i += stride(e))
    {
      assemble(i, q, shift, committed, trial, edge.rows);
      if (trial[i].touching)
        boost::hash_combine(edge.touching, i);
    }
    edge.tool_force = tool_force_;
    edge.known = true;
  }


  void ContactIteration::assemble(const unsigned int i,
                                  const Vector &q,
                                  const Tensor1 &shift,
                                  const Points &committed,
                                  Points &trial,
                                  AssemblyTarget &target)
  {
    Work &work = work_[i];
    ContactPoint &point = work.point;
    ContactPointState &state = trial[i];
    if (!in_place_)
    {
      projector_.describe(q, i, point);
      state.set_place(point, shift);
    }
    const bool known = in_place_ && work.is_near;
    work.is_near = point.area > 0 && (work.foreseen || !law_.is_free_when_clear(state) ||
                                      !projector_.certainly_clear(i, state.position, point.offset));
    if (work.is_near)
      meet(i, known, q, committed, trial, target);
    else
      leave(i, q, state, target);
  }


  void ContactIteration::find_clear(const unsigned int e, const Vector &q, const Tensor1 &shift, const Points &trial)
  {
    if (!clear_.used())
      return;
    const unsigned int n = projector_.group();
    double clearance = std::numeric_limits<double>::infinity();
    for (unsigned int i = e * n; i < (e + 1) * n; i += stride(e))
    {
      const Work &work = work_[i];
      const ContactPointState &state = trial[i];
      if (work.is_near || state.multiplier != 0. || work.base_multiplier != 0. || work.step_multiplier != 0.)
        clearance = -1.;
      else if (work.point.area > 0)
        clearance = std::min(clearance, projector_.clear_way(i, state.position, work.point.offset));
    }
    clear_.set(e, q, shift, work_[e * n].point, clearance);
  }


  void ContactIteration::describe(const unsigned int first,
                                  const unsigned int end,
                                  const Vector &q,
                                  const Tensor1 &shift,
                                  Points &trial)
  {
    for (unsigned int i = first; i < end; ++i)
    {
      projector_.describe(q, i, work_[i].point);
      trial[i].set_place(work_[i].point, shift);
    }
  }


  void ContactIteration::complete(const Vector &q, const Tensor1 &shift, Points &trial)
  {
    const unsigned int n = projector_.group();
    for (unsigned int e = 0; e < edges_.size(); ++e)
      if (clear_.known(e))
        describe(e * n, (e + 1) * n, q, shift, trial);
      else if (stride(e) > 1)
        describe(e * n + 1, (e + 1) * n - 1, q, shift, trial);
  }


  void ContactIteration::complete_flat(const Vector &q, const Tensor1 &shift, Points &trial)
  {
    const unsigned int n = projector_.group();
    for (unsigned int e = 0; e < edges_.size(); ++e)
      if (stride(e) > 1 && edges_[e].touching != 0)
        describe(e * n + 1, (e + 1) * n - 1, q, shift, trial);
  }


  void ContactIteration::leave(const unsigned int i, const Vector &q,
                               ContactPointState &state,
                               AssemblyTarget &to)
  {
    status_changed_ |= state.touching;
    state.touching = false;
    state.force = state.tangential_force = 0.;
    state.gap = projector_.last_distance(i) - work_[i].point.offset;
    law_.close(q, first_multiplier_ + i, to);
  }


  void ContactIteration::meet(const unsigned int i,
                              const bool known,
                              const Vector &q,
                              const Points &committed,
                              Points &trial,
                              AssemblyTarget &target)
  {
    ContactPointState &state = trial[i];
    const ContactPointState &before = committed[i];
    Work &work = work_[i];
    const ContactPoint &point = work.point;
    if (!known)
      work.projection = projector_.project(i, state.position);
    const Projection &projection = work.projection;
    state.gap = gap_of(projection, point, state);
    state.arc_length = projection.arc_length;
    if ((law_.is_concerned(state) || work.foreseen.value_or(false)) && !(state.stiffness > 0))
    {
      factors_.touch(i, point, projection, committed, trial);
      if (friction_)
        friction_->start_slip(i, before, state);
    }
    law_.read_unknown(q, first_multiplier_ + i, state);

    const bool held = at_start_ && before.touching;
    const NormalResponse normal =
      law_.respond(state,
                   {state.gap, point.compliance, factors_.share(before), work.foreseen, held});
    state.gap = normal.gap;
    FrictionResponse friction;
    if (friction_ && normal.touching)
      friction = friction_->respond(i, before, state, projection, point.offset, normal.force);
    status_changed_ |= state.touching != normal.touching;
    state.touching = normal.touching;
    state.force = normal.force;
    state.tangential_force = friction.force;
    state.sticking = friction.sticking;
    if (normal.touching)
      state.compliance = point.compliance;
    if (law_.acts(normal))
      add(i, point, projection, normal, friction, state, target);
  }


  void ContactIteration::add(const unsigned int i,
                             const ContactPoint &point,
                             const Projection &projection,
                             const NormalResponse &normal,
                             const FrictionResponse &friction,
                             ContactPointState &state,
                             AssemblyTarget &target)
  {
    const ContactForce force(projection, friction_ ? friction_->transfer(projection, point.offset) : SlipTransfer(),
                             normal, friction);
    if (normal.touching)
      tool_force_ -= force.value();
    PointRows rows(point);
    projector_.counterpart().add_columns(rows);
    law_.join(rows, first_multiplier_ + i);
    rows.add_force(force.value());
    rows.copy_residual(state.residual);
    if (target.wants_tangent())
      rows.add_gradient(force.value(), force.gradient(normal.touching ? std::max(state.multiplier, 0.) : 0.));
    law_.add_equation(normal, state, point.compliance, force, rows);
    rows.add_to(target, target.wants_tangent());
  }


  Tensor1 ContactIteration::motion(const unsigned int i, const Vector &d) const
  {
    return work_[i].point.motion(d, -projector_.counterpart().motion(d));
  }


  bool ContactIteration::foresee(const Vector &q, const Tensor1 &shift, const Vector &d, const Points &trial)
  {
    bool other = false;
    in_place_ = true;
    const Tensor1 end = shift + projector_.counterpart().motion(d);
    const unsigned int n = projector_.group();
    for (unsigned int e = 0; e * n < trial.size(); ++e)
    {
      if (clear_.clear(e, q, &d, end))
        continue;
      bool own = false;
      for (unsigned int i = e * n; i < (e + 1) * n; i += stride(e))
      {
        if (clear_.known(e))
          projector_.describe(q, i, work_[i].point);
        own |= foresee(i, d, trial[i]);
      }
      if (own)
      {
        clear_.discard(e);
        if (!edges_.empty())
          edges_[e].known = false;
      }
      other |= own;
    }
    return other;
  }


  bool ContactIteration::foresee(const unsigned int i, const Vector &d, const ContactPointState &state)
  {
    Work &work = work_[i];
    if (work.is_near)
    {
      work.foreseen = law_.foresee(state, work.projection.normal * motion(i, d), work.point.compliance);
      return *work.foreseen != state.touching;
    }
    if (!(state.area > 0 && motion(i, d).norm() > state.gap))
      return false;
    // It was not projected. If it may come to the tool it has to be, and is free until that is known.
    work.foreseen = false;
    return true;
  }


  template <typename Action>
  void ContactIteration::for_each_asked(const Action &action) const
  {
    const unsigned int n = projector_.group();
    for (unsigned int e = 0; e * n < work_.size(); ++e)
      if (!clear_.known(e))
        for (unsigned int i = e * n; i < (e + 1) * n; i += stride(e))
          action(i);
  }


  void ContactIteration::prepare_step(const Vector &d, const Points &committed, const Points &trial)
  {
    at_start_ = false;
    for_each_asked([&](const unsigned int i) {
      const ContactPointState &state = trial[i];
      Work &work = work_[i];
      work.base_multiplier = state.multiplier;
      const double opening = state.touching ? work.projection.normal * motion(i, d) : 0.;
      work.step_multiplier = law_.estimate(state, opening, factors_.share(committed[i])) - state.multiplier;
    });
  }


  void ContactIteration::advance(const double factor, Points &trial)
  {
    in_place_ = false;
    for_each_asked([&](const unsigned int i) {
      work_[i].foreseen.reset();
      trial[i].multiplier = work_[i].base_multiplier + factor * work_[i].step_multiplier;
    });
  }


  std::size_t ContactIteration::signature(const Points &trial) const
  {
    std::size_t result = 0;
    if (edges_.empty())
    {
      for (const auto &state : trial)
        boost::hash_combine(result, state.touching);
      return result;
    }
    for (const auto &edge : edges_)
      boost::hash_combine(result, edge.touching);
    return result;
  }


  std::vector<ContactIteration::Frame> ContactIteration::frames(const Points &trial) const
  {
    std::vector<Frame> result;
    for (unsigned int i = 0; i < trial.size(); ++i)
      if (trial[i].touching)
        result.push_back({work_[i].point.dofs[0], work_[i].point.dofs[1], work_[i].projection.normal});
    return result;
  }
} // namespace deltaform
