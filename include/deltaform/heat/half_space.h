#pragma once

#include <deltaform/assembly/point_origin.h>

#include <utility>
#include <vector>

namespace deltaform
{
  /**
   * The surface of a tool that is so thick that heat does not reach its other side, at several points. Heat flows along
   * the normal only: every point is a half-space of its own, with the rise of its surface
   *
   *     T(t) = 1/(e sqrt(pi)) int_0^t q(s)/sqrt(t - s) ds,
   *
   * q the flux into it, e = sqrt(k rho c) its effusivity (H.S. Carslaw, J.C. Jaeger, Conduction of Heat in Solids,
   * Oxford 1959, section 2.9). The kernel is a sum of exponentials, whose memory has a fixed size: the trapezoidal rule
   * in ln(x) makes of 1/sqrt(pi t) = 2/pi int exp(-x^2 t) dx
   *
   *     1/sqrt(pi t) = ln(2)/pi sum_k 2^(k/2) exp(-2^k t)   to a relative 2e-6 for every t,
   *
   * all k. The rates 2^k are 1e-12 to 1e12 here (1/time); slower ones are 0, faster ones follow the flux at once. The
   * flux is constant over an increment, which the sums integrate exactly.
   */
  class HalfSpace
  {
  public:
    /// @param effusivity force/length/temperature/time^0.5
    HalfSpace(double effusivity, unsigned int n_points);

    /// Begin an increment of @p duration.
    void begin(double duration);

    /// How a joint of @p conductance looks from the blank at the end of the increment: the flux through it is the first
    /// number times the rise of the blank over the second one. @p flux is what else flows into the tool.
    std::pair<double, double> joint(unsigned int point, double conductance, double flux) const;

    /// End the increment, with the @p flux into each point (force/length/time).
    void end(const std::vector<double> &flux);

    unsigned int n_points() const
    {
      return surface_.size();
    }

    /// Of the surface at each point.
    const std::vector<double> &rise() const
    {
      return surface_;
    }

    /// The points are others: each is the mean of two old ones.
    void transfer(const std::vector<PointOrigin> &origins);

    /// @name What the points remember
    ///@{
    std::vector<double> state() const;

    /// @p state of @p n_points. @throws SceneError if it has another size
    void set_state(const std::vector<double> &state, unsigned int n_points);
    ///@}

  private:
    /// A share of the memory at all points.
    struct Mode
    {
      double rate, weight;
      double kept = 1., taken = 0.; ///< of itself, of the flux, over the increment
    };

    /// Of the surface at the end of the increment, without flux.
    double rest(unsigned int point) const;

    double inverse_effusivity_;
    std::vector<Mode> modes_;
    double rise_per_flux_ = 0; ///< over the increment
    std::vector<double> heat_; ///< what each mode holds, point by point (force/length)
    std::vector<double> surface_;
  };
} // namespace deltaform
