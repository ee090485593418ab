// Proportional: eps := eps max(1, p / delta) after convergence, as Code_Aster adapts its penalty coefficient to a
// largest penetration (keyword PENE_MAXI; document R5.03.50). A stiffer point takes more load, so p approaches delta
// from above and never arrives: a tolerance ends the corrections, and p <= delta is not promised. The factor never
// falls.
#include <deltaform/contact/penalty_rule.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class Proportional : public PenaltyRule
    {
    public:
      explicit Proportional(Section &section)
        : start_(section.number("Start factor",
                                1.,
                                Range::positive(),
                                "1",
                                "Penalty factor of a first touch in units of the nodal stiffness K_nn.")),
          tolerance_(section.number("Proportional tolerance",
                                    .05,
                                    Range::positive(),
                                    "1",
                                    "Accepted excess of the penetration over delta, relative to delta."))
      {
      }

      double predict(const PenaltyInput &input) const override
      {
        return input.previous_factor > 0 ? input.previous_factor : start_ * input.stiffness;
      }

      double correct(const PenaltyInput &input) const override
      {
        const double ratio = input.penetration / input.delta;
        return ratio > 1. + tolerance_ ? input.previous_factor * ratio : input.previous_factor;
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
      double start_, tolerance_;
    };

    const Registry<PenaltyRule>::Entry entry("proportional",
                                             "eps := eps max(1, penetration/delta) after convergence; delta may be "
                                             "exceeded",
                                             &make_as<Proportional, PenaltyRule>);
  } // namespace
} // namespace deltaform
