// Constant: eps = C per node (as in the paper), or eps_i = C A_i per area. The classical approach. Promises nothing.
// A point that touches for the first time starts at K_nn if that is softer and is stiffened by factors of 100 after
// each converged solve until C is reached: the first touch of a thin blank at full stiffness does not converge.
#include <deltaform/contact/penalty_rule.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class Constant : public PenaltyRule
    {
    public:
      explicit Constant(Section &section)
        : factor_(section.number("Penalty factor",
                                 1e7,
                                 Range::positive(),
                                 "force/length (per node) or stress/length (per area)",
                                 "The factor of rule 'constant'.")),
          per_area_(section.choice("Penalty factor is",
                                   "per node",
                                   {"per node", "per area"},
                                   "Per node as in the paper, or multiplied by the tributary area.") == "per area"),
          continuation_(
            section.flag("Continuation",
                         true,
                         "Stiffen a first touch step by step up to the factor instead of starting with it."))
      {
      }

      double predict(const PenaltyInput &input) const override
      {
        const double target = goal(input);
        if (input.previous_factor > 0 || !continuation_)
          return target;
        return std::min(target, input.stiffness);
      }

      double correct(const PenaltyInput &input) const override
      {
        return std::min(goal(input), 100. * input.previous_factor);
      }

      double floor(const PenaltyInput &) const override
      {
        return 0.;
      }

      bool promises() const override
      {
        return false;
      }

    private:
      double goal(const PenaltyInput &input) const
      {
        return per_area_ ? factor_ * input.area : factor_;
      }

      double factor_;
      bool per_area_, continuation_;
    };

    const Registry<PenaltyRule>::Entry entry("constant",
                                             "one factor for all points; promises nothing about the penetration",
                                             &make_as<Constant, PenaltyRule>);
  } // namespace
} // namespace deltaform
