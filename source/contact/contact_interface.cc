// The loop over the contact points: their forces, and what they add to residual and tangent.
#include "slip_transfer.h"

#include <deltaform/contact/contact_interface.h>
#include <deltaform/geometry/curvature.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    std::unique_ptr<InterfaceFriction> make_friction(Section &tool_section)
    {
      auto law = make_friction_law(tool_section);
      return law ? std::make_unique<InterfaceFriction>(std::move(law)) : nullptr;
    }
  } // namespace


  ContactInterface::ContactInterface(const ContactSurface &surface,
                                     Tool &tool,
                                     const ContactSettings &settings,
                                     Section tool_section)
    : tool_(tool), settings_(settings), projector_(surface, tool, tool_section),
      friction_(make_friction(tool_section)), factors_(settings, friction_.get(), surface.modulus())
  {
    resize();
  }


  void ContactInterface::set_dofs(const DofIndex travel, const DofIndex first_multiplier)
  {
    travel_dof_ = travel;
    first_multiplier_ = first_multiplier;
  }


  void ContactInterface::assemble(const Vector &q, AssemblyTarget &target)
  {
    tool_force_ = Tensor1();
    status_changed_ = false;
    const Tensor1 shift = travel(q) * tool_.direction();
    if (tool_.force_driven())
    {
      const double residual = -tool_.force(trial_.time), zero = 0.;
      target.add(&travel_dof_, 1, target.wants_tangent() ? &zero : nullptr, &residual);
    }
    ContactNode node;
    for (unsigned int i = 0; i < trial_.points.size(); ++i)
    {
      projector_.describe(q, i, node);
      ContactPointState &state = trial_.points[i];
      state.position = node.x - shift;
      state.area = node.area;
      state.thickness = node.thickness;
      if (passed_over(i, node))
        leave(i, node, q, target);
      else
        meet(i, node, q, target);
    }
  }


  bool ContactInterface::passed_over(const unsigned int i, const ContactNode &node) const
  {
    const ContactPointState &state = trial_.points[i];
    return !(node.area > 0) ||
           (!settings_.enforcement->has_multiplier() && !(state.multiplier > 0) && !(state.shift > 0) &&
            projector_.certainly_clear(i, state.position, node.offset));
  }


  void ContactInterface::leave(const unsigned int i, const ContactNode &node, const Vector &q, AssemblyTarget &target)
  {
    ContactPointState &state = trial_.points[i];
    status_changed_ |= state.touching;
    state.touching = false;
    state.force = state.tangential_force = 0.;
    state.gap = projector_.last_distance(i) - node.offset;
    if (!settings_.enforcement->has_multiplier())
      return;
    // A node without area has no contact, but its multiplier needs an equation: lambda = 0.
    const DofIndex dof = first_multiplier_ + i;
    const double residual = q[dof], one = 1.;
    target.add(&dof, 1, target.wants_tangent() ? &one : nullptr, &residual);
  }


  double ContactInterface::gap(const Projection &projection, const ContactNode &node, ContactPointState &state) const
  {
    // A blank that just rests on a tool touches it, whatever the last digit says.
    const double size =
      state.position.norm() + node.offset + (projection.turning != 0 ? 1 / std::abs(projection.turning) : 0.);
    state.noise = 8 * std::numeric_limits<double>::epsilon() * size;
    const double gap = projection.distance - node.offset;
    return gap > 0 && gap < 2 * state.noise ? 0. : gap;
  }


  void ContactInterface::meet(const unsigned int i, const ContactNode &node, const Vector &q, AssemblyTarget &target)
  {
    ContactPointState &state = trial_.points[i];
    const bool own_unknown = settings_.enforcement->has_multiplier();
    const Projection projection = projector_.project(i, state.position);
    state.gap = gap(projection, node, state);
    state.arc_length = projection.arc_length;
    if ((state.gap <= 0 || own_unknown || state.multiplier > 0) && !(state.stiffness > 0))
      touch(i, node, projection);
    if (own_unknown)
      state.multiplier = q[first_multiplier_ + i];

    const NormalResponse normal = normal_response(i, state.gap, node.compliance);
    FrictionResponse friction;
    if (friction_ && normal.touching)
    {
      const ContactPointState &before = committed_.points[i];
      const double start = before.touching ? before.arc_length : state.slip_start;
      const double slip = offset_slip(tool_.shape(), start, projection.arc_length, node.offset);
      friction = friction_->respond(i, before, state, slip, normal.force);
    }
    status_changed_ |= state.touching != normal.touching;
    state.touching = normal.touching;
    state.force = normal.force;
    state.tangential_force = friction.force;
    state.sticking = friction.sticking;
    if (normal.touching)
    {
      state.compliance = node.compliance;
      work_[i].node = node;
      work_[i].normal = projection.normal;
    }
    if (normal.touching || own_unknown)
      add_point(i, node, projection, normal, friction, target);
  }


  void ContactInterface::touch(const unsigned int i, const ContactNode &node, const Projection &projection)
  {
    factors_.touch(i, node, projection, committed_.points, trial_.points);
    if (friction_ && !committed_.points[i].touching)
      trial_.points[i].slip_start = projector_.look(i, committed_.points[i].position).arc_length;
  }


  NormalResponse ContactInterface::normal_response(const unsigned int i, const double gap, const double compliance)
  {
    ContactPointState &state = trial_.points[i];
    const bool own_unknown = settings_.enforcement->has_multiplier();
    const double share = state.spring_share(compliance);
    const double left = share * (gap + compliance * state.shift);
    NormalResponse normal = respond(i, own_unknown ? gap : left);
    normal.derivative *= share;
    if (own_unknown)
      normal.compliance = compliance;
    if (normal.touching)
      state.gap = own_unknown ? gap + compliance * normal.force : left;
    const double soft = factors_.share(committed_.points[i]);
    if (soft < 1)
    {
      normal.force *= own_unknown ? 1. : soft;
      normal.derivative *= soft;
      normal.compliance += own_unknown ? 1. / (soft * state.stiffness) : 0.;
    }
    return normal;
  }


  void ContactInterface::add_point(const unsigned int i,
                                   const ContactNode &node,
                                   const Projection &projection,
                                   const NormalResponse &normal,
                                   const FrictionResponse &friction,
                                   AssemblyTarget &target)
  {
    constexpr std::size_t most = ContactNode::max_dofs + 2;
    std::array<DofIndex, most> dofs;
    std::array<Tensor1, most> jacobian;
    std::array<double, most> residual;
    std::array<double, most * most> matrix;
    unsigned int n = 0;

    // What moves the point relative to the tool: the node's unknowns, and the tool itself backwards.
    for (; n < node.n_dofs; ++n)
    {
      dofs[n] = node.dofs[n];
      jacobian[n] = node.jacobian[n];
    }
    if (tool_.force_driven())
    {
      dofs[n] = travel_dof_;
      jacobian[n++] = -tool_.direction();
    }
    const unsigned int n_motion = n;
    const bool own_unknown = settings_.enforcement->has_multiplier();
    if (own_unknown)
      dofs[n++] = first_multiplier_ + i;

    const auto &N = projection.normal, &tau = projection.tangent;
    const SlipTransfer slip = friction_ ? slip_transfer(tool_.shape(), node.offset, projection) : SlipTransfer();
    const double s = slip.share;
    const Tensor1 force = normal.force * N - friction.force * s * tau;
    if (normal.touching)
      tool_force_ -= force;

    ContactPointState &state = trial_.points[i];
    for (unsigned int k = 0; k < n_motion; ++k)
      residual[k] = -(force * jacobian[k]);
    std::copy_n(residual.begin(), node.n_dofs, state.residual.begin());
    const double lambda = state.multiplier;
    if (own_unknown)
      residual[n_motion] = normal.tied ? -state.gap - (normal.compliance - node.compliance) * lambda : lambda;

    if (!target.wants_tangent())
    {
      target.add(dofs.data(), n, nullptr, residual.data());
      return;
    }

    // dF/dx: the normal turns with the tool's curvature, the friction force follows normal force and slip.
    const double turning = projection.turning, t = friction.force;
    const double pressing = normal.touching ? std::max(lambda, 0.) : 0.;
    Tensor2 dF;
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = 0; b < 2; ++b)
        dF[a][b] =
          normal.derivative * N[a] * N[b] + pressing * turning * tau[a] * tau[b] -
          s * tau[a] * (friction.slip_rate * slip.slip_rate * tau[b] + friction.force_rate * normal.derivative * N[b]) -
          t * tau[a] * (slip.along_normal * N[b] + slip.along_tangent * tau[b]) + t * s * turning * N[a] * tau[b];
    matrix.fill(0.);
    for (unsigned int k = 0; k < n_motion; ++k)
    {
      for (unsigned int l = 0; l < n_motion; ++l)
        matrix[k * n + l] = -(jacobian[k] * (dF * jacobian[l]));
      if (k < node.n_dofs)
        matrix[k * n + k] -= force * node.second[k];
    }
    if (own_unknown)
    {
      const unsigned int m = n_motion;
      const Tensor1 dforce = N - friction.force_rate * s * tau;
      matrix[m * n + m] = normal.tied ? -normal.compliance : 1.;
      if (normal.tied)
        for (unsigned int k = 0; k < n_motion; ++k)
        {
          matrix[k * n + m] = -(dforce * jacobian[k]);
          matrix[m * n + k] = -(N * jacobian[k]);
        }
    }
    target.add(dofs.data(), n, matrix.data(), residual.data());
  }
} // namespace deltaform
