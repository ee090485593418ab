#include <deltaform/base/registry.h>
#include <deltaform/materials/hardening.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /**
     * Two-branch power law: s(e) = s0 + min(K1 e^n1, K2 e^n2), s0 >= 0 and K1, K2 > 0 stresses, 0 < n1, n2 <= 1.
     * Continuous and unbounded; concave; the slope is infinite at e = 0 (larger exponent < 1) and drops where the
     * branches cross, at e = (K2 / K1)^(1 / (n1 - n2)).
     *
     * D.M. Woo, On the complete solution of the deep-drawing problem, Int. J. Mech. Sci. 10 (1968) 83, whose material
     * this is, is quoted in print with s = 5.4 + 27.8 e^.504 for e <= .36 and 5.4 + 24.4 e^.504 beyond. With one
     * exponent the flow stress jumps at .36 from 22.01 down to 19.98; with .375 in the second branch it is continuous
     * to .1 %. The printed exponent is taken for a misprint. `As printed` gives the law with the jump, s = s0 + K1 e^n1
     * up to the switch strain and s0 + K2 e^n1 beyond, for material points only: with a jump down, equilibrium at given
     * load may have no solution, and no scene must converge with it.
     */
    class TwoBranchPower : public Hardening
    {
    public:
      explicit TwoBranchPower(Section &section)
        : initial_(section.number("Initial flow stress",
                                  required(5.4),
                                  Range::not_negative(),
                                  "stress",
                                  "Flow stress s0 at plastic strain 0.")),
          first_{
            section.number("First coefficient", required(27.8), Range::positive(), "stress", "K1, of small strains."),
            section.number("First exponent", required(.504), Range::above_to(0., 1.), "1", "Exponent n1.")},
          second_{
            section.number("Second coefficient", required(24.4), Range::positive(), "stress", "K2, of large strains."),
            first_.exponent}
      {
        const bool as_printed =
          section.flag("As printed",
                       false,
                       "Switch from K1 to K2 at the switch strain, both with the first exponent, although the flow "
                       "stress jumps there. For material points only: no scene must converge with it.");
        if (as_printed || section.documentation())
          switch_ = section.number(
            "Switch strain", .36, Range::positive(), "1", "Where K2 takes over; only for the law as printed.");
        if (as_printed)
          return;
        second_.exponent = section.number(
          "Second exponent", required(.375), Range::above_to(0., 1.), "1", "Exponent n2; not for the law as printed.");

        // The smaller one of the branches is the one with the larger exponent up to where they cross.
        const bool same = first_.exponent == second_.exponent;
        if (same ? first_.coefficient > second_.coefficient : first_.exponent < second_.exponent)
          std::swap(first_, second_);
        switch_ = same ? std::numeric_limits<double>::infinity()
                       : std::pow(second_.coefficient / first_.coefficient, 1. / (first_.exponent - second_.exponent));
      }

      FlowStress evaluate(const double e) const override
      {
        const Branch &branch = e <= switch_ ? first_ : second_;
        if (e > 0.)
        {
          const double power = branch.coefficient * std::pow(e, branch.exponent);
          return {initial_ + power, branch.exponent * power / e};
        }
        return {initial_, first_.exponent < 1. ? std::numeric_limits<double>::infinity() : first_.coefficient};
      }

    private:
      struct Branch
      {
        double coefficient, exponent;
      };

      double initial_;
      Branch first_, second_;
      double switch_ = 0.; ///< strain up to which the first branch holds
    };

    const Registry<Hardening>::Entry
      entry("two-branch power", "s0 + min(K1 e^n1, K2 e^n2)", make_as<TwoBranchPower, Hardening>);
  } // namespace
} // namespace deltaform
