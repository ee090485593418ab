// Element stiffness: eps_i = f E A_i / t, the stiffness of the piece of blank behind the node (A_i: tributary area, t:
// thickness, E: Young's modulus) times a factor. The usual default of explicit codes (Hallquist, LS-DYNA theory manual,
// chapter on contact: k = f K A^2 / V for solids, f K A / diagonal for shells). Knows neither load nor delta: promises
// nothing.
#include <deltaform/contact/penalty_rule.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  namespace
  {
    class ElementStiffness : public PenaltyRule
    {
    public:
      explicit ElementStiffness(Section &section)
        : factor_(section.number("Stiffness factor",
                                 .1,
                                 Range::positive(),
                                 "1",
                                 "f in eps = f E A / t of rule 'element stiffness'."))
      {
      }

      double predict(const PenaltyInput &input) const override
      {
        return factor_ * input.modulus * input.area / input.thickness;
      }

      double correct(const PenaltyInput &input) const override
      {
        return input.previous_factor;
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
      double factor_;
    };

    const Registry<PenaltyRule>::Entry
      entry("element stiffness", "eps = f E A / t; promises nothing", &make_as<ElementStiffness, PenaltyRule>);
  } // namespace
} // namespace deltaform
