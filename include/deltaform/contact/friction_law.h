#pragma once

#include <limits>
#include <memory>
#include <string>

namespace deltaform
{
  class Section;

  /// Tangential force of a contact point and its derivatives.
  struct FrictionResponse
  {
    double force = 0; ///< t (force)
    double slip_rate = 0; ///< dt/d slip
    double force_rate = 0; ///< dt/d lambda, of a point that is coupled at a constant mean pressure
    double pressure_rate = 0; ///< dt/d mean pressure of the edge (area), of such a point
    bool sticking = true;
  };

  /// What a law may know of a contact point. Area and flow stress are foreseen, the path is that of the last increment:
  /// constants of the tangent.
  struct FrictionInput
  {
    double normal_force = 0; ///< lambda (force), that of the mean pressure where others share an edge with the point
    bool coupled = false; ///< does the tangent know how they do?
    double share = 1; ///< of the limit, where they do: what the point itself has of lambda
    double committed = 0; ///< t at the last accepted increment (force)
    double slip_increment = 0; ///< change of the closest point's arc length since then
    double stiffness = 0; ///< eps_t > 0 (force/length)
    double area = 0; ///< tributary area
    double slip = 0; ///< path of sliding until the last accepted increment (length)
    double flow_stress = std::numeric_limits<double>::infinity(); ///< of the blank's surface; finite for a plastic
      ///< blank whose law asks for it
  };

  /// The largest |t|.
  struct FrictionLimit
  {
    double value = 0; ///< not negative (force)
    double rate = 0; ///< d value / d lambda
  };

  /**
   * Tangential force from the slip of an increment. A law is what its limit is: below it a contact point sticks by an
   * elastic spring, at it the point slips against the force.
   */
  class FrictionLaw
  {
  public:
    virtual ~FrictionLaw() = default;

    /// For a share of one.
    virtual FrictionLimit limit(const FrictionInput &input) const = 0;

    /// Return mapping of the trial force t_n + eps_t ds to the limit (Giannakopoulos, Comput. Struct. 32 (1989) 157).
    virtual FrictionResponse update(const FrictionInput &input) const;

    /// Can the law, with its coefficients, exert a force at all?
    virtual bool acts() const = 0;

    /// Is the limit no multiple of lambda? The points of an edge then have to share it.
    virtual bool depends_on_pressure() const
    {
      return false;
    }

    /// Does it want FrictionInput::flow_stress?
    virtual bool needs_flow_stress() const
    {
      return false;
    }

    /// What is doubtful about its coefficients, beginning with an entry's name; empty: nothing.
    virtual std::string doubt() const
    {
      return "";
    }
  };

  /// The law that the section of a tool names; null if it cannot exert a force: then contact has no friction to deal
  /// with.
  std::unique_ptr<FrictionLaw> make_friction_law(Section &tool_section);
} // namespace deltaform
