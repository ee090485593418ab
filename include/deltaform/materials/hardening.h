#pragma once

namespace deltaform
{
  /// Flow stress and its slope at one equivalent plastic strain.
  struct FlowStress
  {
    double value; ///< Kirchhoff stress
    double slope; ///< d value / d equivalent plastic strain; may be infinite at zero strain (power laws)
  };

  /**
   * Isotropic hardening: flow stress s(e) >= 0 (Kirchhoff stress) against the equivalent (logarithmic) plastic strain
   * e >= 0. Must be continuous and never fall under s(0); the slope may be unbounded at e = 0.
   */
  class Hardening
  {
  public:
    virtual ~Hardening() = default;

    virtual FlowStress evaluate(double equivalent_plastic_strain) const = 0;

    /// Integral of s(e) de from 0 to e is not needed: dissipation is integrated along the path.
  };
} // namespace deltaform
