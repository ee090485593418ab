#pragma once

#include <deltaform/materials/hardening.h>
#include <deltaform/materials/parameter_table.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

/**
 * @file
 * The hardening laws as values: flow stress s (Kirchhoff stress) and slope against the equivalent plastic strain
 * e >= 0. They take any numbers; parameters() says which make sense, and its check() throws if these do not. Formulas
 * stand here, so that they are compiled into the loops that call them; the .cc of each law has its table and its name
 * in a scene.
 */
namespace deltaform
{
  /// s(e) = s0, s0 > 0 a stress; slope 0. R. Hill, The Mathematical Theory of Plasticity, Oxford 1950, chapter II.
  struct PerfectlyPlastic
  {
    double s0;

    FlowStress operator()(double) const
    {
      return {s0, 0.};
    }

    static const ParameterTable<PerfectlyPlastic> &parameters();
  };


  /**
   * s(e) = s0 + H e, s0 > 0 and H >= 0 stresses; unbounded. In uniaxial tension the tangent modulus is E H / (E + H).
   * R. Hill, The Mathematical Theory of Plasticity, Oxford 1950, chapter II.
   */
  struct LinearHardening
  {
    double s0, H;

    FlowStress operator()(const double e) const
    {
      return {s0 + H * e, H};
    }

    static const ParameterTable<LinearHardening> &parameters();
  };


  /**
   * Ludwik: s(e) = s0 + K e^n, s0 >= 0 and K >= 0 stresses, 0 < n <= 1; unbounded. The slope n K e^(n-1) is infinite
   * at e = 0 (n < 1, K > 0). P. Ludwik, Elemente der technologischen Mechanik, Springer 1909.
   */
  struct Ludwik
  {
    double s0, K, n;

    FlowStress operator()(const double e) const
    {
      if (e > 0.)
      {
        const double power = K * std::pow(e, n);
        return {s0 + power, n * power / e};
      }
      const bool unbounded = n < 1. && K > 0.;
      return {s0, unbounded ? std::numeric_limits<double>::infinity() : K};
    }

    static const ParameterTable<Ludwik> &parameters();
  };


  /**
   * Swift: s(e) = K (e0 + e)^n, K > 0 a stress, prestrain e0 >= 0, 0 < n <= 1. Initial flow stress K e0^n; unbounded;
   * the slope at e = 0 is n K e0^(n-1), infinite for e0 = 0, n < 1.
   * H.W. Swift, Plastic instability under plane stress, J. Mech. Phys. Solids 1 (1952) 1.
   */
  struct Swift
  {
    double K, e0, n;

    FlowStress operator()(const double e) const
    {
      const double x = e0 + e;
      const double value = K * std::pow(x, n);
      if (x > 0.)
        return {value, n * value / x};
      return {value, n < 1. ? std::numeric_limits<double>::infinity() : K};
    }

    static const ParameterTable<Swift> &parameters();
  };


  /**
   * Voce, with a linear term: s(e) = s0 + (ss - s0) (1 - exp(-b e)) + H e, 0 <= s0 <= ss and H >= 0 stresses, b > 0.
   * Goes to ss + H e; initial slope b (ss - s0) + H.
   * E. Voce, The relationship between stress and strain for homogeneous deformation, J. Inst. Metals 74 (1948) 537.
   */
  struct Voce
  {
    double s0, ss, b, H = 0.;

    FlowStress operator()(const double e) const
    {
      const double risen = -std::expm1(-b * e), rise = ss - s0;
      return {s0 + rise * risen + H * e, rise * b * (1. - risen) + H};
    }

    static const ParameterTable<Voce> &parameters();
  };


  /**
   * Hockett and Sherby: s(e) = ss - (ss - s0) exp(-m e^n), 0 <= s0 <= ss stresses, m > 0, 0 < n <= 1. Goes to ss; the
   * slope at e = 0 is infinite for n < 1, m (ss - s0) for n = 1 (Voce's law).
   * J.E. Hockett, O.D. Sherby, Large strain deformation of polycrystalline metals at low homologous temperatures, J.
   * Mech. Phys. Solids 23 (1975) 87.
   */
  struct HockettSherby
  {
    double s0, ss, m, n;

    FlowStress operator()(const double e) const
    {
      const double rise = ss - s0;
      if (e > 0.)
      {
        const double power = m * std::pow(e, n);
        const double risen = -std::expm1(-power);
        return {s0 + rise * risen, rise * (1. - risen) * n * power / e};
      }
      const bool unbounded = n < 1. && rise > 0.;
      return {s0, unbounded ? std::numeric_limits<double>::infinity() : rise * m};
    }

    static const ParameterTable<HockettSherby> &parameters();
  };


  /**
   * Two-branch power law: s(e) = s0 + min(K1 e^n1, K2 e^n2), s0 >= 0 and K1, K2 > 0 stresses, 0 < n1, n2 <= 1.
   * Continuous and unbounded; concave; the slope is infinite at e = 0 (larger exponent < 1) and drops where the
   * branches cross, at e = (K2 / K1)^(1 / (n1 - n2)).
   *
   * D.M. Woo, On the complete solution of the deep-drawing problem, Int. J. Mech. Sci. 10 (1968) 83, whose material
   * this is, is quoted in print with s = 5.4 + 27.8 e^.504 for e <= .36 and 5.4 + 24.4 e^.504 beyond. With one
   * exponent the flow stress jumps at .36 from 22.01 down to 19.98; with .375 in the second branch it is continuous
   * to .1 %. The printed exponent is taken for a misprint.
   */
  class TwoBranchPower
  {
  public:
    struct Branch
    {
      double K, n;
    };

    TwoBranchPower(double s0, Branch first, Branch second);

    /**
     * The law with the jump, s = s0 + K1 e^n up to the switch strain and s0 + K2 e^n beyond, for material points only:
     * with a jump down, equilibrium at given load may have no solution, and no scene must converge with it.
     */
    static TwoBranchPower as_printed(double s0, double K1, double K2, double n, double switch_strain);

    FlowStress operator()(const double e) const
    {
      const Branch &branch = e <= switch_ ? first_ : second_;
      if (e > 0.)
      {
        const double power = branch.K * std::pow(e, branch.n);
        return {s0_ + power, branch.n * power / e};
      }
      return {s0_, first_.n < 1. ? std::numeric_limits<double>::infinity() : first_.K};
    }

  private:
    double s0_;
    Branch first_, second_; ///< of small and of large strains
    double switch_; ///< strain up to which the first branch holds
  };


  /**
   * Measured curve: rows (e, s), at least four, e from 0 upwards strictly increasing, s > 0 not decreasing. Between
   * the rows the monotone piecewise cubic through them: continuous slope, no overshoot, exact for points on a line.
   * Beyond the last row s is constant (slope 0), as in Abaqus: what was not measured is not invented. Give a last row
   * beyond the strains expected if hardening is to go on. Strains are logarithmic plastic strains, stresses Kirchhoff
   * stresses (for metals the true stress, up to the elastic change of volume). F.N. Fritsch, J. Butland, A method for
   * constructing local monotone piecewise cubic interpolants, SIAM J. Sci. Stat. Comput. 5 (1984) 300.
   */
  class FlowCurve
  {
  public:
    /// @throws std::invalid_argument if the rows are not like that
    explicit FlowCurve(const std::vector<std::vector<double>> &rows);

    FlowStress operator()(double e) const;

  private:
    struct Interpolant;

    double last_strain_, last_stress_;
    std::shared_ptr<const Interpolant> interpolant_; ///< shared by copies: it never changes
  };
} // namespace deltaform
