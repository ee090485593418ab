#pragma once
// Equations for tests of the search for the set of active inequalities.
#include "convergence.h"

namespace deltaform
{
  namespace testing
  {
    /// What such equations have in common: steps are admissible, sets consistent, and nothing is corrected.
    class SetsProblem : public Equations, public ActiveSet
    {
    public:
      double typical_length() const override
      {
        return 1.;
      }

      double limit_step(const Vector & /*q*/, Vector & /*d*/) const override
      {
        return 1.;
      }

      ActiveSet *active_set() override
      {
        return this;
      }

      void advance(double /*factor*/) override
      {
      }

      bool changed() const override
      {
        return false;
      }

      unsigned int patience() const override
      {
        return 1000;
      }

      bool consistent(double /*allowed_tension*/) const override
      {
        return true;
      }

      unsigned int correct(const Vector & /*q*/) override
      {
        return 0;
      }
    };
  } // namespace testing
} // namespace deltaform
