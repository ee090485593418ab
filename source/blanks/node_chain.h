#pragma once

#include <deltaform/assembly/contact_surface.h>

#include <array>
#include <vector>

namespace deltaform
{
  /// The nodes of a sheet one after the other, and the direction of its face at each.
  class NodeChain
  {
  public:
    /// The edges, in order, are these (ContactSurface::contact_edges()).
    void set_up(unsigned int n_nodes, const std::vector<std::array<unsigned int, 3>> &edges);

    /// Of a node: the one before it and the one after it. invalid_index: the sheet ends there.
    const std::array<unsigned int, 2> &neighbours(const unsigned int node) const
    {
      return neighbours_[node];
    }

    bool ends_at(const unsigned int node) const
    {
      return neighbours_[node][0] == invalid_index || neighbours_[node][1] == invalid_index;
    }

    /// At the middle one of three contact points in a row: of the parabola by the lengths of their chords.
    static ContactSurface::FaceDirection
    direction(const ContactPoint &before, const ContactPoint &point, const ContactPoint &after);

  private:
    std::vector<std::array<unsigned int, 2>> neighbours_;
  };
} // namespace deltaform
