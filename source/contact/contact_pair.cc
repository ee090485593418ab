// The node loop: who touches, with which force, and what it adds to residual and tangent.
#include <deltaform/contact/contact_pair.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /// Share of the friction force that a node receives, with its gradient, and d(slip)/d(displacement along the
    /// tangent): the same but for the penetration.
    struct SlipTransfer
    {
      double share = 0., along_normal = 0., along_tangent = 0., slip_rate = 0.;
    };

    /**
     * 1/(1 + k distance) with the mean curvature k of the tool over the thickness. With the curvature at the foot point
     * the force would jump where a line meets an arc, and a node that comes to rest there would have no equilibrium.
     */
    SlipTransfer slip_transfer(const Shape &shape, const double offset, const Projection &projection)
    {
      if (offset == 0. || projection.slip_rate == 0.)
        return {projection.slip_rate, -projection.turning * projection.slip_rate, 0., projection.slip_rate};
      const double k = shape.mean_curvature(projection.arc_length, offset);
      const double s = 1. / (1. + k * projection.distance);
      const double k_point = projection.turning / (1. - projection.turning * projection.distance);
      return {s,
              -s * s * k,
              -s * s * projection.distance * projection.slip_rate *
                shape.curvature_change(projection.arc_length, offset),
              projection.slip_rate * (1. + k_point * offset) / (1. + k * offset)};
    }
  } // namespace


  ContactPair::ContactPair(const ContactSurface &surface,
                           Tool &tool,
                           const ContactSettings &settings,
                           Section tool_section)
    : surface_(surface), tool_(tool), settings_(settings)
  {
    const std::string thickness =
      tool_section.choice("Contact thickness",
                          "current",
                          {"current", "initial", "none"},
                          "Thickness that keeps the tool from the mid-surface of a shell: as last "
                          "accepted, initial (a tool with a fixed gap to another), or none.");
    thickness_ = thickness == "current"   ? ContactThickness::current
                 : thickness == "initial" ? ContactThickness::initial
                                          : ContactThickness::none;
    const std::string squeeze = tool_section.choice(
      "Squeeze",
      "on",
      {"on", "off"},
      "Does the half of a shell's thickness on this side give way at once, by pressure over Young's "
      "modulus, or only when the increment is accepted?");
    squeezed_ = squeeze == "on";
    friction_ = make_friction_law(tool_section);
    resize();
  }


  double ContactPair::slip_share(const Projection &projection, const double offset) const
  {
    return slip_transfer(tool_.shape(), offset, projection).share;
  }


  void ContactPair::set_dofs(const DofIndex travel, const DofIndex first_multiplier)
  {
    travel_dof_ = travel;
    first_multiplier_ = first_multiplier;
  }


  double ContactPair::travel(const Vector &q) const
  {
    return tool_.force_driven() ? q[travel_dof_] : tool_.travel(time_);
  }


  ContactNode ContactPair::node(const Vector &q, const unsigned int i) const
  {
    ContactNode result;
    describe(q, i, result);
    return result;
  }


  void ContactPair::describe(const Vector &q, const unsigned int i, ContactNode &node) const
  {
    surface_.contact_node(q, tool_.side(), i, thickness_, node);
    if (squeezed_)
      node.offset += node.relief;
    else
      node.squeeze = 0.;
  }


  void ContactPair::begin_stage(const Vector &q, const double time)
  {
    time_ = last_time_ = time;
    last_step_ = 0.;
    const Tensor1 shift = travel(q) * tool_.direction();
    for (unsigned int i = 0; i < committed_.size(); ++i)
    {
      const ContactNode description = node(q, i);
      committed_x_[i] = description.x - shift;
      thickness_of_[i] = description.thickness;
    }
    std::fill(projected_gap_.begin(), projected_gap_.end(), -1.);
  }


  void ContactPair::begin_increment(const double time)
  {
    time_ = time;
    softening_ = 1.;
    at_start_ = true;
    slack_ = 0.;
    slip_limit_ = settings_.allowed_slip(time);
    if (friction_ && friction_->needs_flow_stress())
      flow_stress_ = surface_.flow_stress(tool_.side());
    trial_ = committed_;
    const TimeFunction *own = tool_.allowed_penetration();
    const double asked = own ? (*own)(time) : settings_.allowed_penetration(time);
    const double delta = asked < 0 ? -asked * automatic_delta() : asked;
    for (auto &state : trial_)
    {
      state.delta = delta;
      state.multiplier = state.touching ? state.force : 0.;
    }

    std::vector<double> factors;
    for (const auto &state : committed_)
      if (state.touching && state.epsilon > 0)
        factors.push_back(state.epsilon);
    median_factor_ = 0.;
    if (!factors.empty())
    {
      std::nth_element(factors.begin(), factors.begin() + factors.size() / 2, factors.end());
      median_factor_ = factors[factors.size() / 2];
    }
  }


  bool ContactPair::certainly_clear(const unsigned int i, const Point2 &relative, const double offset) const
  {
    const double clearance = projected_gap_[i] - offset;
    return clearance > 0 && (relative - projected_x_[i]).norm_square() < clearance * clearance;
  }


  void ContactPair::assemble(const Vector &q, AssemblyTarget &target)
  {
    tool_force_ = Tensor1();
    status_changed_ = false;
    const double travel_now = travel(q);
    const Tensor1 shift = travel_now * tool_.direction();
    const bool own_unknown = settings_.enforcement->has_multiplier();
    const unsigned int n = trial_.size();

    if (tool_.force_driven())
    {
      const double residual = -tool_.force(time_), zero = 0.;
      target.add(&travel_dof_, 1, target.wants_tangent() ? &zero : nullptr, &residual);
    }
    ContactNode node;
    for (unsigned int i = 0; i < n; ++i)
    {
      describe(q, i, node);
      PairState &state = trial_[i];
      const Point2 relative = node.x - shift;
      x_[i] = relative;
      area_[i] = node.area;
      thickness_of_[i] = node.thickness;
      if (!(node.area > 0) ||
          (!own_unknown && !(state.multiplier > 0) && !(state.shift > 0) && certainly_clear(i, relative, node.offset)))
      {
        status_changed_ |= state.touching;
        state.touching = false;
        state.force = state.tangential_force = 0.;
        state.gap = projected_gap_[i] - node.offset;
        if (own_unknown)
        {
          // A node without area has no pair, but its multiplier needs an equation: lambda = 0.
          const DofIndex dof = first_multiplier_ + i;
          const double residual = q[dof], one = 1.;
          target.add(&dof, 1, target.wants_tangent() ? &one : nullptr, &residual);
        }
        continue;
      }

      const Projection projection = tool_.project(relative, 0., hint_[i]);
      hint_[i] = projection.segment;
      projected_x_[i] = relative;
      projected_gap_[i] = std::isfinite(projection.distance) ? projection.distance : -1.;
      double gap = projection.distance - node.offset;
      // A blank that just rests on a tool touches it, whatever the last digit says.
      const double size =
        relative.norm() + node.offset + (projection.turning != 0 ? 1 / std::abs(projection.turning) : 0.);
      noise_[i] = 8 * std::numeric_limits<double>::epsilon() * size;
      if (gap > 0 && gap < 2 * noise_[i])
        gap = 0.;
      state.gap = gap;
      state.arc_length = projection.arc_length;
      if ((gap <= 0 || own_unknown || state.multiplier > 0) && !(state.stiffness > 0))
        touch(i, node, projection);

      if (own_unknown)
        state.multiplier = q[first_multiplier_ + i];
      const double compliance = node.squeeze;
      const double share = spring_share(state, compliance);
      const double left = share * (gap + compliance * state.shift);
      NormalResponse normal = respond(i, own_unknown ? gap : left);
      normal.derivative *= share;
      if (own_unknown)
        normal.compliance = compliance;
      if (normal.touching)
        state.gap = own_unknown ? gap + compliance * normal.force : left;
      if (softening_ < 1 && !committed_[i].touching)
      {
        normal.force *= own_unknown ? 1. : softening_;
        normal.derivative *= softening_;
        normal.compliance += own_unknown ? 1. / (softening_ * state.stiffness) : 0.;
      }
      const FrictionResponse friction =
        friction_ && normal.touching ? friction_response(i, node, projection, normal) : FrictionResponse();
      status_changed_ |= state.touching != normal.touching;
      state.touching = normal.touching;
      state.force = normal.force;
      state.tangential_force = friction.force;
      state.sticking = friction.sticking;
      if (normal.touching)
      {
        description_[i] = node;
        normal_[i] = projection.normal;
      }
      if (normal.touching || own_unknown)
        add_pair(i, node, projection, normal, friction, target);
    }
  }


  FrictionResponse ContactPair::friction_response(const unsigned int i,
                                                  const ContactNode &node,
                                                  const Projection &projection,
                                                  const NormalResponse &normal) const
  {
    // The limit belongs to the estimate of lambda; what the iterate's force differs from it enters linearly.
    FrictionInput what = friction_input(i, std::max(trial_[i].multiplier, 0.));
    const double start = committed_[i].touching ? committed_[i].arc_length : trial_[i].slip_start;
    what.slip_increment = tool_.shape().slip(start, projection.arc_length, node.offset);
    FrictionResponse result = friction_->update(what);
    result.force += result.force_rate * (normal.force - what.normal_force);
    return result;
  }


  void ContactPair::add_pair(const unsigned int i,
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

    for (unsigned int k = 0; k < n_motion; ++k)
      residual[k] = -(force * jacobian[k]);
    std::copy_n(residual.begin(), node.n_dofs, residual_[i].begin());
    const double lambda = trial_[i].multiplier;
    if (own_unknown)
      residual[n_motion] = normal.tied ? -trial_[i].gap - (normal.compliance - node.squeeze) * lambda : lambda;

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
