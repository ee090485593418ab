// Coulomb: |t| <= mu lambda. Unbounded in the pressure; units: forces.
#include <deltaform/contact/friction_law.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

namespace deltaform
{
  namespace
  {
    class Coulomb : public FrictionLaw
    {
    public:
      explicit Coulomb(Section &section)
        : coefficient_(section.number("Friction coefficient",
                                      0.,
                                      Range::not_negative(),
                                      "1",
                                      "Coulomb's coefficient mu between this tool and the blank; 0 is smooth."))
      {
      }

      FrictionLimit limit(const FrictionInput &input) const override
      {
        return {coefficient_ * input.normal_force, coefficient_};
      }

      bool acts() const override
      {
        return coefficient_ > 0.;
      }

      std::string doubt() const override
      {
        if (coefficient_ <= 1.)
          return "";
        return "Friction coefficient = " + text::rounded(coefficient_) +
               ": metals on tools have .02 to .5, and no more than .58 of the flow stress is ever carried.";
      }

    private:
      double coefficient_;
    };

    const Registry<FrictionLaw>::Entry entry("coulomb", "|t| <= mu lambda", &make_as<Coulomb, FrictionLaw>);
  } // namespace
} // namespace deltaform
