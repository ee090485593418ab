#pragma once
// Terms of Armstrong and Frederick; private to the backstress laws.
#include <deltaform/materials/back_stress.h>

#include <vector>

namespace deltaform
{
  /**
   * Terms of Armstrong and Frederick, in Ziegler's form, which stays in plane stress with any yield surface:
   *
   *     alpha = sum alpha_i,   d alpha_i = (C_i/q) dev(xi) dx - gamma_i alpha_i dx,   xi = t - alpha,
   *
   * for Mises the same as 2/3 C_i de_p - gamma_i alpha_i dx. By backward Euler
   * alpha_i = (alpha_i,n + C_i x/q dev(xi)) / (1 + gamma_i x). The deviator, because a pressure within alpha would mean
   * nothing. P.J. Armstrong, C.O. Frederick, CEGB report RD/B/N 731 (1966); J.L. Chaboche, Time-independent
   * constitutive theories for cyclic plasticity, Int. J. Plasticity 2 (1986) 149; H. Ziegler, A modification of
   * Prager's hardening rule, Q. Appl. Math. 17 (1959) 55.
   */
  class Chaboche final : public BackStress
  {
  public:
    using Term = BackStressTerm;

    explicit Chaboche(std::vector<Term> terms);

    HistoryLayout history_layout() const override;

    const std::vector<Term> *terms() const override
    {
      return &terms_;
    }

    Mandel value(const double *history) const override;

    BackStressEnd update(const BackStressStart &from,
                         const Mandel &relative_stress,
                         const YieldPoint &at,
                         double x,
                         double *end) const override;

  private:
    std::vector<Term> terms_;
  };
} // namespace deltaform
