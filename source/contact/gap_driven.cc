// Gap driven: the factor follows two successive penetrations p (now) and q (before), after Bussetta, Marceau, Ponthot,
// The adapted augmented Lagrangian method, Comput. Mech. 49 (2012) 259, algorithm for the normal coefficient:
//
//     p <= delta: keep
//     |p - q| > max(p/10, q, 5 delta), the point has hardly been in contact: 2 eps
//     p within 1 % of q, or falling, p < 10 delta: eps (sqrt(p/delta - 1) + 1)^2
//     p > 1.01 q: 2 eps q/p
//     otherwise: eps (sqrt(p/delta - 1) + 1)
//
// Their first branch, for a gap that changes its sign, is that of separating points: those have no correction here.
// With a tolerance, as for 'proportional'; promises nothing.
#include <deltaform/contact/penalty_rule.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    class GapDriven : public PenaltyRule
    {
    public:
      explicit GapDriven(Section &section)
        : start_(section.number("Start factor",
                                1.,
                                Range::positive(),
                                "1",
                                "Penalty factor of a first touch in units of the nodal stiffness K_nn."))
      {
      }

      double predict(const PenaltyInput &input) const override
      {
        return input.previous_factor > 0 ? input.previous_factor : start_ * input.stiffness;
      }

      double correct(const PenaltyInput &input) const override
      {
        const double p = input.penetration, q = input.previous_penetration, epsilon = input.previous_factor;
        if (p <= input.delta)
          return epsilon;
        const double root = std::sqrt(p / input.delta - 1.) + 1.;
        if (std::abs(p - q) > std::max({.1 * p, q, 5. * input.delta}))
          return 2. * epsilon;
        if (p <= 1.01 * q && p < 10. * input.delta)
          return epsilon * root * root;
        if (p > 1.01 * q && q > 0)
          return epsilon * std::max(1.01, 2. * q / p);
        return epsilon * root;
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
      double start_;
    };

    const Registry<PenaltyRule>::Entry
      entry("gap driven",
            "eps from two successive penetrations (Bussetta, Marceau, Ponthot 2012); promises nothing",
            &make_as<GapDriven, PenaltyRule>);
  } // namespace
} // namespace deltaform
