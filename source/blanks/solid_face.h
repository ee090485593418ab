#pragma once

#include "foreseen_values.h"
#include "solid_boundary.h"
#include "solid_space.h"

#include <deltaform/assembly/contact_surface.h>

#include <array>
#include <string>
#include <vector>

namespace deltaform
{
  /// One side of a solid as contact sees it: the nodes of chains of edges, in order, with their places and areas.
  class SolidFace
  {
  public:
    explicit SolidFace(const SolidSpace &space)
      : space_(space)
    {
    }

    /// String the edges of @p parts of the boundary together.
    void set_up(const SolidBoundary &boundary, const std::vector<std::string> &parts);

    /// Nodes without area in the undeformed body (degree 2: on the axis) have none ever, so that contact has no point
    /// there. @p length: a typical one of edges. Areas are those of the undeformed body afterwards.
    void set_up_areas(double length);

    /// Tributary areas of the nodes at @p q; zero for those that never have one.
    std::vector<double> areas_at(const Vector &q) const;

    /// By the numbers of the space.
    const std::vector<unsigned int> &nodes() const
    {
      return nodes_;
    }

    /// By the numbers of contact nodes.
    const std::vector<Edge> &edges() const
    {
      return edges_;
    }

    /// Ends of an edge, by the numbers of the space.
    std::array<unsigned int, 2> ends(const Edge &edge) const
    {
      return {{nodes_[edge[0]], nodes_[edge[1]]}};
    }

    ForeseenValues &areas()
    {
      return areas_;
    }
    const ForeseenValues &areas() const
    {
      return areas_;
    }

    /// See ContactSurface; all but the thickness.
    void contact_point(const Vector &q, unsigned int node, ContactPoint &result) const;

    /// Any place of an edge, @p xi from 0 to 1, carried by its nodes; its area is that of the edge per xi.
    void contact_place(const Vector &q, unsigned int edge, double xi, ContactPoint &result) const;

    /// Distance of a point from the chords of the edges; infinite if there are none.
    double distance(const Vector &q, const Point2 &x) const;

    /// Shortest distance of undeformed neighbours; infinite if there are no edges.
    double shortest_edge() const;

    /// Undeformed.
    std::vector<Point2> places() const;

  private:
    /// Append a node. @return its number
    unsigned int add(unsigned int node);
    void add(const std::vector<Edge> &chain);

    const SolidSpace &space_;
    std::vector<unsigned int> nodes_;
    std::vector<Edge> edges_;
    std::vector<double> arc_; ///< S0
    std::vector<bool> weightless_;
    ForeseenValues areas_; ///< of the nodes
  };
} // namespace deltaform
