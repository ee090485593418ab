#pragma once

#include <optional>
#include <string>

namespace deltaform
{
  /**
   * What a scene's label of units, 'mm, N, MPa' (length, force, stress), means in m, N and Pa. The program computes in
   * any consistent system; the label is needed only to take over constants that have a unit, and to find values that
   * cannot be. A stress may be a quotient such as 'tonf/in^2'. What is not known is empty.
   */
  struct UnitSystem
  {
    explicit UnitSystem(const std::string &label);

    std::optional<double> length; ///< in m
    std::optional<double> force; ///< in N
    std::optional<double> stress; ///< in Pa

    /// A sentence if the unit of stress is not that of force over that of length squared; else empty.
    std::string objection() const;

    /// The unit that is written in other letters, small or capital, than one that is known ("Mpa"), and the known one;
    /// empty if there is none.
    std::string misspelt() const;

  private:
    std::string label_;
  };
} // namespace deltaform
