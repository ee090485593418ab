// Adaptive: eps_i = max(beta K_nn, lambda_i / (alpha delta_i)) with lambda_i of the last increment. Points that share
// their unknowns keep a larger factor that is not more than kappa = 4 times as large: equilibrium says what they carry
// together, not which of them does; with factors that follow a falling force at once, p is alpha delta wherever the
// force is, and a sheet that slides finds other springs each time it comes back. Close to equilibrium and after
// convergence a point with p_i > delta_i gets eps_i min(10, p_i / (alpha delta_i)), alpha = .8. At equilibrium the
// incremental eqn (7) of Bednarek, Kowalczyk has the only fixed point lambda / delta; aiming at .8 delta reaches
// penetration <= delta from the safe side in a finite number of corrections. Derivation: doc/theory/contact.md.
#include <deltaform/contact/penalty_rule.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    class Adaptive : public PenaltyRule
    {
    public:
      explicit Adaptive(Section &section)
        : floor_factor_(
            section.number("Floor factor",
                           .01,
                           Range::not_negative(),
                           "1",
                           "Lower bound of the penalty factor over the nodal stiffness K_nn; keeps lightly loaded "
                           "contact points from flipping in and out of contact.")),
          aim_(section.number("Aim",
                              .8,
                              Range::inside(0., 1.),
                              "1",
                              "Share of the allowed penetration that is aimed at, so that corrections end.")),
          largest_change_(section.number("Largest change",
                                         10.,
                                         Range{1., 1e6, true, false},
                                         "1",
                                         "Largest change of a penalty factor by a correction, a ratio."))
      {
      }

      double predict(const PenaltyInput &input) const override
      {
        const double lowest = floor(input);
        if (input.previous_factor <= 0)
        {
          // Without a floor the very first touch still needs a value.
          const double start = std::max(lowest, input.neighbour);
          return start > 0 ? start : 1e-2 * input.stiffness;
        }
        const double wanted = std::max(lowest, input.force / (aim_ * input.delta));
        const double kept = input.shares_unknowns ? std::min(input.previous_factor, excess_ * wanted) : 0.;
        return std::clamp(
          std::max(wanted, kept), input.previous_factor / largest_change_, input.previous_factor * largest_change_);
      }

      double correct(const PenaltyInput &input) const override
      {
        if (input.penetration <= input.delta)
          return input.previous_factor;
        return input.previous_factor * std::min(largest_change_, input.penetration / (aim_ * input.delta));
      }

      double floor(const PenaltyInput &input) const override
      {
        return floor_factor_ * input.stiffness;
      }

      bool promises() const override
      {
        return true;
      }

    private:
      static constexpr double excess_ = 4.; ///< kappa
      double floor_factor_, aim_, largest_change_;
    };

    const Registry<PenaltyRule>::Entry entry("adaptive",
                                             "eps from the reaction and delta; promises penetration <= delta",
                                             &make_as<Adaptive, PenaltyRule>);
  } // namespace
} // namespace deltaform
