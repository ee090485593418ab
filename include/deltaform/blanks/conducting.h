#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/types.h>
#include <deltaform/materials/metal_heat.h>

#include <array>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * A blank through whose mesh heat flows. Its nodes have a rise of temperature over the initial one each; a vector of
   * these values has the numbering of the unknowns and holds that of a node at the place of its u_r. So it follows a
   * refinement as displacements do. All but assemble() are for all processes together.
   */
  class Conducting
  {
  public:
    virtual ~Conducting() = default;

    virtual const MetalHeat &metal() const = 0;

    /// Where the value of a node of the boundary stands, which never hangs.
    virtual DofIndex place_of(unsigned int node) const = 0;

    /// Values at all nodes, by their places in Blank::positions().
    virtual std::vector<double> at_nodes(const Vector &rise) const = 0;

    /**
     * Add the heat balance of the own cells, C (T - T_n) + dt K T - Q, at T = @p rise = T_n, and its matrix C + dt K. C
     * belongs to the undeformed body, K to the one at @p q; Q is the heat that the points have made since give() (all:
     * force*length).
     */
    virtual void assemble(const Vector &q, const Vector &rise, double duration, AssemblyTarget &target) const = 0;

    /// Q of all points (force*length).
    virtual double heat_of_flow(const Vector &rise) const = 0;

    /// Heat in the blank over that at its initial temperature (force*length).
    virtual double stored_heat() const = 0;

    /// The points take the temperature of the nodes around them.
    virtual void give(const Vector &rise) = 0;

    /// An edge of the boundary: its nodes, and their shares of its area now.
    struct FilmEdge
    {
      unsigned int n_nodes;
      std::array<unsigned int, 3> nodes;
      std::array<double, 3> areas;
    };

    /// Of a part of the boundary. @throws std::invalid_argument if there is no such part
    virtual std::vector<FilmEdge> edges(const Vector &q, const std::string &part) const = 0;
  };
} // namespace deltaform
