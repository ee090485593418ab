#pragma once

namespace deltaform
{
  /// What a rule may know of a contact point; all of it is in the rows of contact_*.csv or can be derived from them.
  struct PenaltyInput
  {
    double force = 0; ///< lambda: reaction of the point (last increment, or converged iterate)
    double penetration = 0;
    double previous_penetration = 0; ///< when the rule was asked before; 0 at a first touch
    double previous_factor = 0; ///< 0 if the point had none
    double stiffness = 0; ///< K_nn = n^T K n of the blank without contact
    double coupling = 0; ///< [C^T K C (penetration - delta)]_i, if the rule needs it
    double area = 0; ///< tributary area
    double thickness = 0; ///< of the blank at the node
    double modulus = 0; ///< Young's modulus of the blank
    double delta = 0; ///< allowed penetration
    bool shares_unknowns = false; ///< with other points, as those inside the elements do; a node has its own
    double neighbour = 0; ///< larger of the neighbouring points' and the tool's median factor; for a first touch
  };

  /// The penalty factor of a contact point: a pure function of its input.
  class PenaltyRule
  {
  public:
    virtual ~PenaltyRule() = default;

    /// Factor at the start of an increment, or (force and previous_factor zero) when the point touches for the first
    /// time.
    virtual double predict(const PenaltyInput &input) const = 0;

    /// Factor after a converged solve. Returning previous_factor accepts the point as it is.
    virtual double correct(const PenaltyInput &input) const = 0;

    /// Lower bound of the factor that does not come from delta (for the column floor_share); 0: none.
    virtual double floor(const PenaltyInput &input) const = 0;

    /// Does the rule promise penetration <= delta? If so, a violation ends the run with exit status 3.
    virtual bool promises() const = 0;

    /// Is predict() called in every Newton iteration with the current force, penetration and coupling?
    virtual bool in_every_iteration() const
    {
      return false;
    }

    /// Does it need the coupling?
    virtual bool needs_coupling() const
    {
      return false;
    }
  };
} // namespace deltaform
