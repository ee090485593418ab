// Paper: eqn (7) of Bednarek, Kowalczyk as printed, with the out-of-balance force as r and the current distances:
//
//     eps_i delta_i = lambda_i + [C^T K C (p - delta)]_i
//
// (at equilibrium C^T (r - f_int) is the reaction lambda). p = delta is its only fixed point, but the second term
// predicts the change of the reaction with C^T K C where the condensed stiffness is smaller, so that it overshoots and
// may turn negative. The safeguards can be switched off to see what the printed rule does by itself. Promises nothing.
#include <deltaform/contact/penalty_rule.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class Paper : public PenaltyRule
    {
    public:
      explicit Paper(Section &section)
        : every_iteration_(
            section.choice("Paper update",
                           "increment",
                           {"increment", "iteration"},
                           "Evaluate eqn (7) once per increment, or in every Newton iteration as the paper says.") ==
            "iteration"),
          clamp_(
            section.flag("Paper clamp", true, "Safeguard: where eqn (7) turns negative keep the previous factor.")),
          floor_(section.number("Paper floor",
                                1e-2,
                                Range::not_negative(),
                                "1",
                                "Safeguard: smallest factor / K_nn; 0: off.")),
          cap_(
            section.number("Paper cap", 1e6, Range::not_negative(), "1", "Safeguard: largest factor / K_nn; 0: off."))
      {
      }

      double predict(const PenaltyInput &input) const override
      {
        if (input.previous_factor == 0)
          return input.stiffness;
        double epsilon = (input.force + input.coupling) / input.delta;
        if (clamp_ && epsilon <= 0)
          epsilon = input.previous_factor;
        if (floor_ > 0)
          epsilon = std::max(epsilon, floor_ * input.stiffness);
        if (cap_ > 0)
          epsilon = std::min(epsilon, cap_ * input.stiffness);
        return epsilon;
      }

      double correct(const PenaltyInput &input) const override
      {
        return input.previous_factor;
      }

      double floor(const PenaltyInput &input) const override
      {
        return floor_ * input.stiffness;
      }

      bool promises() const override
      {
        return false;
      }

      bool in_every_iteration() const override
      {
        return every_iteration_;
      }

      bool needs_coupling() const override
      {
        return true;
      }

    private:
      bool every_iteration_, clamp_;
      double floor_, cap_;
    };

    const Registry<PenaltyRule>::Entry
      entry("paper",
            "eqn (7) as printed, with safeguards that can be switched off; promises nothing",
            &make_as<Paper, PenaltyRule>);
  } // namespace
} // namespace deltaform
