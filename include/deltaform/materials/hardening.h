#pragma once

#include <memory>
#include <utility>

namespace deltaform
{
  class RateFactor;

  /// Flow stress and its slope at one equivalent plastic strain.
  struct FlowStress
  {
    double value; ///< Kirchhoff stress
    double slope; ///< d value / d equivalent plastic strain; may be infinite at zero strain (power laws)
  };

  /**
   * Isotropic hardening: flow stress s(e) >= 0 (Kirchhoff stress) against the equivalent (logarithmic) plastic strain
   * e >= 0. Must be continuous and never fall under s(0); the slope may be unbounded at e = 0. The laws themselves are
   * values (hardening_laws.h).
   */
  class Hardening
  {
  public:
    virtual ~Hardening() = default;

    /// A law that knows rate and temperature answers for a vanishing rate and the temperature at the start.
    virtual FlowStress evaluate(double equivalent_plastic_strain) const = 0;

    /**
     * The rate factor of a law that depends on rate and temperature itself; null: it does not.
     * The result outlives the law.
     * @param heating rise of temperature per plastic work of a volume (temperature/stress); 0: none is counted
     */
    virtual std::unique_ptr<RateFactor> own_rate_factor(double heating) const;
  };


  /// The hardening of a value @p Law with `FlowStress operator()(double) const`.
  template <typename Law>
  class HardeningOf final : public Hardening
  {
  public:
    explicit HardeningOf(Law law)
      : law_(std::move(law))
    {
    }

    FlowStress evaluate(const double equivalent_plastic_strain) const override
    {
      return law_(equivalent_plastic_strain);
    }

  private:
    Law law_;
  };


  /// Hardening without a scene: hardening_of(Swift{589., 1e-4, .216}).
  template <typename Law>
  std::unique_ptr<Hardening> hardening_of(Law law)
  {
    return std::make_unique<HardeningOf<Law>>(std::move(law));
  }
} // namespace deltaform
