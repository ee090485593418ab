#pragma once

namespace deltaform
{
  /// What a rise of the temperature leaves of the flow stress.
  struct Softened
  {
    double factor; ///< in [0, 1]; 1 without a rise
    double slope; ///< d factor / d rise (1/temperature), not positive
  };

  /// Softening by heat: the flow stress times a factor that does not grow with the temperature.
  class Softening
  {
  public:
    virtual ~Softening() = default;

    /// @p rise over the temperature at the start, not negative.
    virtual Softened evaluate(double rise) const = 0;
  };
} // namespace deltaform
