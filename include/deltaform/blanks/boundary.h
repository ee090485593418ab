#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/types.h>

#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /// A direction in which displacements and loads can be prescribed.
  enum class Component : unsigned char
  {
    r,
    z,
    rotation
  };


  /// A node of a sheet, in the order along it.
  struct LineNode
  {
    double arc; ///< arc length along the undeformed sheet (length)
    double r; ///< of the undeformed blank (length)
    DofIndex unknown; ///< its displacement along r
  };


  /// A blank as supports and loads see it: named parts of its boundary, and its volume.
  class Boundary
  {
  public:
    virtual ~Boundary() = default;

    /// Names of the parts.
    virtual std::vector<std::string> parts() const = 0;

    /// Unknowns of one component on a part; empty if the blank has no such component (the rotation of a solid).
    /// @throws std::invalid_argument if there is no such part.
    virtual std::vector<DofIndex> dofs(const std::string &part, Component component) const = 0;

    /// Where the unknowns of dofs() are in the undeformed blank, one point per unknown.
    virtual std::vector<Point2> points(const std::string &part) const = 0;

    /// Forces of a unit load on a part on the unknowns of dofs(): initial circumference of an edge (shell; line loads),
    /// consistent share of the initial area (solid; tractions).
    virtual std::vector<double> weights(const std::string &part) const = 0;

    /// Parts on which a pressure may act, the usual one first.
    virtual std::vector<std::string> faces() const = 0;

    /// The nodes of one of faces(), by their places in Blank::positions().
    virtual std::vector<unsigned int> face_nodes(const std::string &face) const = 0;

    /// Add the forces of a pressure on one of faces(), positive if it pushes into the blank (on the bottom: along the
    /// director, upward for a flat blank). Following: on the current area along the current normal; dead: on the
    /// initial area and normal.
    virtual void assemble_pressure(const Vector &q,
                                   const std::string &face,
                                   double pressure,
                                   bool following,
                                   AssemblyTarget &target) const = 0;

    /// Unknowns of a displacement component with their consistent shares of the initial volume, for body loads.
    virtual std::vector<std::pair<DofIndex, double>> volume_weights(Component component) const = 0;

    /// The nodes of a sheet from its start to its end: a line of the mid-surface (shell), or one of the bottom and one
    /// of the top (solid). Neighbours belong to one cell. None if the blank is no sheet.
    virtual std::vector<std::vector<LineNode>> lines() const = 0;
  };
} // namespace deltaform
