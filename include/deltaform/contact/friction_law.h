#pragma once

namespace deltaform
{
  /// Tangential force of a pair and its derivatives.
  struct FrictionResponse
  {
    double force = 0; ///< t
    double slip_rate = 0; ///< dt/d slip
    double force_rate = 0; ///< dt/d lambda
    bool sticking = true;
  };

  /// Tangential force from the normal force and the slip of an increment.
  class FrictionLaw
  {
  public:
    virtual ~FrictionLaw() = default;

    /**
     * @param normal_force   lambda >= 0
     * @param committed      t at the last accepted increment
     * @param slip_increment change of the foot point's arc length since then
     * @param stiffness      eps_t > 0
     */
    virtual FrictionResponse
    update(double normal_force, double committed, double slip_increment, double stiffness) const = 0;

    /// Largest |t| at a normal force.
    virtual double limit(double normal_force) const = 0;
  };
} // namespace deltaform
