#pragma once

#include "blank_surface.h"
#include "face_points.h"
#include "solid_discretization.h"
#include "solid_face.h"

#include <deltaform/io/keyed_arrays.h>

#include <array>
#include <string>
#include <vector>

namespace deltaform
{
  /// Bottom and top of a solid as contact sees them, and what lies between them.
  class SolidSurface : public BlankSurface
  {
  public:
    /// Read which parts of the boundary tools touch. @p moves: areas are the current ones, not the initial ones
    SolidSurface(Section &section, const SolidDiscretization &body, const MaterialPoints &material, bool moves);

    /// Nodes and initial areas on the mesh as it is now. @throws SceneError if the first mesh has no such parts
    void set_up(const Section &section);

    /// The same on a refined mesh.
    void set_up();

    /// See Blank::touch_inside().
    void touch_inside();

    /// Does the scene not say where the contact points are?
    bool left_open() const
    {
      return left_open_;
    }

    /// Areas and thickness of a state that no increment led to.
    void update(const Vector &q);

    /// Of an increment that was accepted.
    void accept(const Vector &q);

    /// See Blank::begin_increment().
    void begin_increment(double ratio);

    /// A saved state was taken.
    void renew();

    unsigned int n_contact_dofs() const override;
    unsigned int n_nodes() const override;
    double largest_motion(Side side,
                          unsigned int edge,
                          const std::array<double, ContactPoint::max_dofs> &change) const override;
    const std::vector<std::array<unsigned int, 3>> &contact_edges(Side side) const override;
    void contact_place(const Vector &q,
                       Side side,
                       unsigned int edge,
                       double xi,
                       ContactThickness thickness,
                       ContactPoint &result) const override;

    /// Where the contact points of a side lie on the undeformed body.
    FacePoints points(Side side) const;

    const SolidFace &face(const unsigned int side) const
    {
      return faces_[side];
    }

    /// Of the mesh as read; the thickness if nothing can touch.
    double shortest_edge() const
    {
      return shortest_edge_;
    }

    /// Accepted, from bottom to top; of a body without these the one that is read.
    double smallest_thickness() const
    {
      return smallest_thickness_;
    }

    /// Every array of the state with its name.
    template <typename Surface, typename Action>
    static void each_array(Surface &surface, const Action &action)
    {
      for (unsigned int side = 0; side < 2; ++side)
        ForeseenValues::each_array(surface.faces_[side].areas(), names_of_nodes[side], action);
      action("smallest thickness", surface.smallest_thickness_);
      if (!surface.at_nodes())
        for (unsigned int side = 0; side < 2; ++side)
          ForeseenValues::each_array(surface.point_areas_[side], names_of_points[side], action);
      each_flow_stress(surface, action);
    }

    /// The earlier operation of this state may have touched elsewhere, with another friction: what belongs to contact
    /// points is left to update().
    void leave_open(KeyedArrays &state) const
    {
      if (!at_nodes())
        for (const auto *const name : names_of_points)
          ForeseenValues::each_array(ForeseenValues(), name, PutInto(state));
      each_flow_stress(*this, PutInto(state));
    }

  private:
    /// Measure areas at @p q, take them as @p take says, and measure the thickness.
    void measure(const Vector &q, void (ForeseenValues::*take)(std::vector<double>));

    static constexpr std::array<const char *, 2> names_of_nodes{{"area of nodes, bottom", "area of nodes, top"}};
    static constexpr std::array<const char *, 2> names_of_points{
      {"area of contact points, bottom", "area of contact points, top"}};

    std::vector<double> nodal_flow_stress(Side side) const override;
    unsigned int n_contact_nodes(Side side) const override;
    void nodal_point(const Vector &q, Side side, unsigned int node, ContactThickness thickness, ContactPoint &result)
      const override;
    double point_area(Side side, unsigned int point) const override;
    double area_at(const Vector &q, Side side, unsigned int edge, double xi) const override;

    const SolidDiscretization &body_;
    bool moves_;
    bool left_open_ = false;
    std::array<std::vector<std::string>, 2> parts_; ///< of the boundary: bottom, top
    std::array<SolidFace, 2> faces_;
    std::array<ForeseenValues, 2> point_areas_; ///< of the contact points inside edges
    double shortest_edge_ = 0;
    double smallest_thickness_ = 0;
  };
} // namespace deltaform
