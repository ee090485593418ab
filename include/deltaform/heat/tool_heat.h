#pragma once

#include <deltaform/materials/metal_heat.h>

#include <optional>

namespace deltaform
{
  class Section;

  /**
   * Heat between the blank and a tool of temperature T_t: the flux h (T - T_t) of a touching point, with the
   * conductance of the joint
   *
   *     h = min(h0 (p/p0)^m, h_max),
   *
   * p the contact pressure; m = .985 is that of rough surfaces that yield (M.G. Cooper, B.B. Mikic, M.M. Yovanovich,
   * Int. J. Heat Mass Transfer 12 (1969) 279). Of the heat of friction the blank takes the share e/(e + e_t),
   * e = sqrt(k rho c) the effusivity: so two half-spaces share what is made between them, at one temperature of both
   * (H.S. Carslaw, J.C. Jaeger, Conduction of Heat in Solids, Oxford 1959, section 2.15). The tool keeps T_t, or warms
   * as a HalfSpace that begins with it.
   */
  class ToolHeat
  {
  public:
    /// Read Heat, a section of the tool. @throws SceneError if the metal would melt at the tool's temperature
    ToolHeat(Section section, const MetalHeat &metal);

    /// h (force/length/time/temperature) at @p pressure, not negative.
    double conductance(double pressure) const;

    /// Of the tool at its start, over the initial temperature of the blank.
    double rise() const
    {
      return rise_;
    }

    /// Of the heat of friction, that the blank takes.
    double blank_share() const
    {
      return blank_share_;
    }

    /// Of the tool if it is a half-space; none: it keeps its temperature.
    std::optional<double> effusivity() const
    {
      return effusivity_;
    }

  private:
    double rise_, conductance_, exponent_, reference_pressure_, largest_, blank_share_;
    std::optional<double> effusivity_;
  };
} // namespace deltaform
