#pragma once

#include <deltaform/materials/back_stress.h>
#include <deltaform/materials/elasticity.h>
#include <deltaform/materials/falling_modulus.h>
#include <deltaform/materials/hardening.h>
#include <deltaform/materials/material.h>
#include <deltaform/materials/rate_factor.h>
#include <deltaform/materials/yield_surface.h>

#include <array>
#include <memory>
#include <optional>

namespace deltaform
{
  /// What a metal is composed of. @p back_stress and @p rate_factor may be null: there is none; a hardening that knows
  /// rate and temperature has its own, which a rate factor that is given replaces.
  struct FlowLaws
  {
    std::unique_ptr<Hardening> hardening;
    std::unique_ptr<YieldSurface> yield_surface;
    std::unique_ptr<BackStress> back_stress = nullptr;
    std::unique_ptr<RateFactor> rate_factor = nullptr;
  };


  /**
   * Metal plasticity at large strain: yield condition in the Kirchhoff stress tau, associated flow, additive in the
   * logarithmic strain,
   *
   *     tau = C : (e - e_p),   q(tau - alpha) <= s(x),   d e_p = dx dq/dtau,   dx >= 0,
   *
   * C isotropic, with a yield surface q, hardening s, backstress alpha and rate factor of any laws that go together.
   * Integrated by backward Euler (first order in the increment; exact where the direction of flow is constant) or by
   * the two-step formula of Bdf2Predictor (second order), with the consistent tangent. Where the yield surface has a
   * return map in closed form, that is used; else the general one. C. Miehe, N. Apel, M. Lambrecht, Anisotropic
   * additive plasticity in the logarithmic strain space, Comput. Methods Appl. Mech. Eng. 191 (2002) 5383.
   */
  class Elastoplastic : public Material
  {
  public:
    enum class Integration : unsigned char
    {
      backward_euler,
      two_steps
    };

    /// @param falling none: Young's modulus is constant; else for given third stress (shells) only, and the plastic
    /// strain of the history is what would remain after unloading with the present modulus
    /// @throws std::invalid_argument if the laws do not go together
    Elastoplastic(const Elasticity &elastic,
                  FlowLaws laws,
                  Integration integration = Integration::two_steps,
                  const std::optional<FallingModulus> &falling = std::nullopt);

    /// The return maps refer to the laws of this object.
    Elastoplastic(const Elastoplastic &) = delete;
    Elastoplastic &operator=(const Elastoplastic &) = delete;

    const HistoryLayout &history_layout() const override;
    MaterialTraits traits() const override;
    bool two_steps() const override;
    std::optional<MetalHeat> heat() const override;
    void set_axes(PointAxes axes) override;
    Status update(const MaterialBatch &batch) const override;
    Mandel elastic_strain(const Mandel &stress) const override;
    double elastic_energy(const Mandel &stress) const override;
    double stored_energy(const Mandel &stress, const double *history) const override;
    Mandel plastic_strain(const double *history) const override;
    double equivalent_plastic_strain(const double *history) const override;
    double flow_stress(const double *history) const override;
    double shear_modulus() const override;
    double young_modulus() const override;
    double poisson_ratio() const override;

  private:
    /// Values of the history of a point, for which there is room on the stack.
    static constexpr std::size_t most_values = 64;

    /// Closed form or general return map, for each question about the third direction.
    void choose_return_maps();

    /// The same for points whose elasticity depends on their history.
    Status update_falling(const MaterialBatch &batch, const ReturnMap &map) const;

    /// Of a point with this history.
    Elasticity elasticity(const double *history) const;

    /// Equivalent stress, less the backstress, of a point with this stress and history.
    double first_stress(Mandel stress, const double *committed) const;

    /// All points, with @p n values of history: a number known to the compiler (closed forms) or not.
    template <typename Size>
    Status update_points(const MaterialBatch &batch, const ReturnMap &map, const Elasticity &elastic, Size n) const;

    Elasticity elastic_; ///< without plastic strain
    std::optional<FallingModulus> falling_;
    FlowLaws laws_;
    Integration integration_;
    HistoryLayout history_;
    double initial_flow_stress_;
    unsigned int rate_first_; ///< where the history of the rate factor begins
    std::array<std::unique_ptr<ReturnMap>, 2> own_; ///< for each ThirdDirection; null: the surface has a closed form
    std::array<const ReturnMap *, 2> map_{}; ///< closed form or own; null: the question cannot be answered
  };
} // namespace deltaform
