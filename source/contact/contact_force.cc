#include <deltaform/contact/contact_force.h>

namespace deltaform
{
  ContactForce::ContactForce(const Projection &projection,
                             const SlipTransfer &slip,
                             const NormalResponse &normal,
                             const FrictionResponse &friction)
    : projection_(projection), slip_(slip), normal_(normal), friction_(friction),
      value_(normal.force * projection.normal - friction.force * slip.share * projection.tangent)
  {
  }


  Tensor1 ContactForce::by_multiplier() const
  {
    return projection_.normal - friction_.force_rate * slip_.share * projection_.tangent;
  }


  Tensor2 ContactForce::gradient(const double pressing) const
  {
    // The normal turns with the tool's curvature, the friction force follows normal force and slip.
    const auto &N = projection_.normal, &tau = projection_.tangent;
    const double curvature = projection_.curvature, t = friction_.force, s = slip_.share;
    Tensor2 result;
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = 0; b < 2; ++b)
        result[a][b] = normal_.derivative * N[a] * N[b] + pressing * curvature * tau[a] * tau[b] -
                       s * tau[a] *
                         (friction_.slip_rate * slip_.slip_rate * tau[b] +
                          friction_.force_rate * normal_.derivative * N[b]) -
                       t * tau[a] * (slip_.along_normal * N[b] + slip_.along_tangent * tau[b]) +
                       t * s * curvature * N[a] * tau[b];
    return result;
  }
} // namespace deltaform
