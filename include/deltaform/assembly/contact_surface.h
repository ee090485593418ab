#pragma once

#include <deltaform/assembly/contact_node.h>
#include <deltaform/assembly/side.h>

#include <array>
#include <vector>

namespace deltaform
{
  /// The faces of a blank as contact sees them: nodes, and edges between the nodes.
  class ContactSurface
  {
  public:
    virtual ~ContactSurface() = default;

    /// Number of unknowns that positions may depend on.
    virtual unsigned int n_contact_dofs() const = 0;

    virtual unsigned int n_contact_nodes(Side side) const = 0;

    /// Young's modulus of the body behind the surface (stress).
    virtual double modulus() const = 0;

    /// Accepted flow stress of the material at every node of one side (stress); infinite where it is elastic. To be
    /// asked by all processes together.
    virtual std::vector<double> flow_stress(Side side) const = 0;

    /// Describe node @p node of one side at @p q.
    virtual void contact_node(const Vector &q,
                              Side side,
                              unsigned int node,
                              ContactThickness thickness,
                              ContactNode &result) const = 0;

    /// Nodes of each edge along the side: its ends, then a middle node (invalid_index: none). Between them the contact
    /// point is interpolated by Lagrange polynomials.
    virtual const std::vector<std::array<unsigned int, 3>> &contact_edges(Side side) const = 0;
  };
} // namespace deltaform
