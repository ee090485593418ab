#pragma once

#include <limits>

namespace deltaform
{
  /// What a metal that conducts says of its heat. The rise of the temperature over the initial one is the field
  /// `temperature_rise` of its history.
  struct MetalHeat
  {
    double capacity = 1; ///< of the volume before deformation (stress/temperature)
    double conductivity = 0; ///< isotropic and constant (force/time/temperature)
    double initial_temperature = 0;
    /// Rise from which on the metal carries nothing: it has molten.
    double melting_rise = std::numeric_limits<double>::infinity();
  };
} // namespace deltaform
