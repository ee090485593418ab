#pragma once

#include <deltaform/increment/equations.h>
#include <deltaform/solver/system.h>

#include <vector>

namespace deltaform
{
  /**
   * The equations of a blank in a viscous medium: R(q) + c M (q - q_k) = 0 is a step of the length 1/c, by the implicit
   * Euler method, of the motion M dq/dt = -R(q), which slides down the potential. M holds the squares of the scales of
   * the unknowns. What is at rest in the medium is an equilibrium without it. C.T. Kelley, D.E. Keyes, Convergence
   * analysis of pseudo-transient continuation, SIAM J. Numer. Anal. 35 (1998) 508.
   */
  class ViscousEquations : public Equations
  {
  public:
    /// @param equations R(q), assembled into @p system
    /// @param scale     of every unknown
    ViscousEquations(Equations &equations, System &system, const std::vector<double> &scale)
      : equations_(equations), system_(system), scale_(scale)
    {
    }

    /// Start a step at @p q. @param viscosity c, force over length
    void begin_step(const Vector &q, const double viscosity)
    {
      start_ = q;
      c_ = viscosity;
    }

    /// c M (q - q_k) of an unknown; zero if it is prescribed.
    double force(const DofIndex i, const Vector &q) const
    {
      return system_.prescribed(i) ? 0. : c_ * scale_[i] * scale_[i] * (q[i] - start_[i]);
    }

    double typical_length() const override
    {
      return equations_.typical_length();
    }

    Status assemble(const Vector &q, bool tangent) override;
    bool assemble_foreseen(const Vector &q) override;

    double limit_step(const Vector &q, Vector &d) const override
    {
      return equations_.limit_step(q, d);
    }

    ActiveSet *active_set() override
    {
      return equations_.active_set();
    }

    unsigned int correct_early() override
    {
      return equations_.correct_early();
    }

    unsigned int correct(const Vector &q) override
    {
      return equations_.correct(q);
    }

  private:
    /// Add c M (q - q_k), and c M to the tangent.
    void add_viscous_forces(const Vector &q);

    Equations &equations_;
    System &system_;
    const std::vector<double> &scale_;
    Vector start_; ///< q_k
    double c_ = 0.;
  };
} // namespace deltaform
