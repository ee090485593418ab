#include <deltaform/materials/hardening_laws.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <cmath>
#include <limits>
#include <utility>

namespace deltaform
{
  TwoBranchPower::TwoBranchPower(const double s0, const Branch first, const Branch second)
    : s0_(s0), first_(first), second_(second)
  {
    // The smaller one of the branches is the one with the larger exponent up to where they cross.
    const bool same = first_.n == second_.n;
    if (same ? first_.K > second_.K : first_.n < second_.n)
      std::swap(first_, second_);
    switch_ =
      same ? std::numeric_limits<double>::infinity() : std::pow(second_.K / first_.K, 1. / (first_.n - second_.n));
  }


  TwoBranchPower TwoBranchPower::as_printed(const double s0,
                                            const double K1,
                                            const double K2,
                                            const double n,
                                            const double switch_strain)
  {
    TwoBranchPower law(s0, {K1, n}, {K2, n});
    law.first_ = {K1, n};
    law.second_ = {K2, n};
    law.switch_ = switch_strain;
    return law;
  }


  namespace
  {
    /// Which entries there are depends on one of them: a table cannot say that.
    std::unique_ptr<Hardening> read(Section &section)
    {
      const double s0 = section.number("Initial flow stress",
                                       required(5.4),
                                       Range::not_negative(),
                                       "stress",
                                       "Flow stress s0 at plastic strain 0.");
      const double K1 =
        section.number("First coefficient", required(27.8), Range::positive(), "stress", "K1, of small strains.");
      const double n1 =
        section.number("First exponent", required(.504), Range::above_to(0., 1.), "1", "Exponent n1.");
      const double K2 =
        section.number("Second coefficient", required(24.4), Range::positive(), "stress", "K2, of large strains.");
      const bool as_printed =
        section.flag("As printed",
                     false,
                     "Switch from K1 to K2 at the switch strain, both with the first exponent, although the flow "
                     "stress jumps there. For single material points: a scene with it may not converge.");
      double switch_strain = 0.;
      if (as_printed || section.documentation())
        switch_strain = section.number(
          "Switch strain", .36, Range::positive(), "1", "Where K2 takes over; only for the law as printed.");
      if (as_printed)
        return hardening_of(TwoBranchPower::as_printed(s0, K1, K2, n1, switch_strain));
      const double n2 = section.number(
        "Second exponent", required(.375), Range::above_to(0., 1.), "1", "Exponent n2; not for the law as printed.");
      return hardening_of(TwoBranchPower(s0, {K1, n1}, {K2, n2}));
    }

    const Registry<Hardening>::Entry entry("two-branch power", "s0 + min(K1 e^n1, K2 e^n2)", read);
  } // namespace
} // namespace deltaform
