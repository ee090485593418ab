#pragma once

#include <limits>

namespace deltaform
{
  /// What a rise of the temperature leaves of the flow stress.
  struct Softened
  {
    double factor; ///< not negative; 1 without a rise, not less below
    double slope; ///< d factor / d rise (1/temperature), not positive
  };

  /// Softening by heat: the flow stress times a factor that does not grow with the temperature.
  class Softening
  {
  public:
    virtual ~Softening() = default;

    /// false: the temperature leaves the flow stress as it is.
    virtual bool acts() const
    {
      return true;
    }

    /// @p rise over the temperature at the start; negative where the metal has been cooled.
    virtual Softened evaluate(double rise) const = 0;

    /// The rise from which on nothing is left of the flow stress; infinite: there is none.
    virtual double melting_rise() const
    {
      return std::numeric_limits<double>::infinity();
    }
  };
} // namespace deltaform
