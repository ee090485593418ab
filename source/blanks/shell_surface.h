#pragma once

#include "blank_surface.h"
#include "foreseen_values.h"
#include "node_chain.h"
#include "shell_meridian.h"
#include "shell_points.h"
#include "shell_space.h"
#include "shell_state.h"

#include <array>
#include <optional>
#include <vector>

namespace deltaform
{
  /// Where the contact point of a node lies (doc/theory/contact.md).
  enum class NodalContact : unsigned char
  {
    normal_offset, ///< the node, half a thickness away from the tool along the tool's normal
    outer_fibre ///< on the face of the blank, half a thickness along the director
  };


  /// Both faces of a shell as contact sees them: its nodes, or points of its smooth meridian between them
  /// (doc/theory/contact.md, "Points inside the elements").
  class ShellSurface : public BlankSurface
  {
  public:
    /// Read where the contact points are.
    ShellSurface(Section &section,
                 const ShellSpace &space,
                 const ShellPoints &points,
                 const MaterialPoints &material,
                 const ShellState &state);

    unsigned int n_contact_dofs() const override;
    unsigned int n_nodes() const override;
    const std::vector<std::array<unsigned int, 3>> &contact_edges(Side side) const override;
    void contact_place(const Vector &q,
                       Side side,
                       unsigned int edge,
                       double xi,
                       ContactThickness thickness,
                       ContactPoint &result) const override;

    void locate_place(const Vector &q,
                      Side side,
                      unsigned int edge,
                      double xi,
                      ContactThickness thickness,
                      ContactPoint &result) const override;

    double largest_motion(Side side,
                          unsigned int edge,
                          const std::array<double, ContactPoint::max_dofs> &change) const override;

    std::optional<FaceDirection>
    face_direction(const Vector &q, Side side, unsigned int point, ContactThickness thickness) const override;

    /// The mesh is another one.
    void set_up();

    /// See Blank::touch_inside(). @param move one point in each edge, at the deepest place
    void touch_inside(bool move);

    /// Angle of the director, of a membrane that of the meridian.
    double director_angle(const Vector &q, unsigned int node) const;

    /// Tributary areas of the nodes at @p q; zero for those that never have one.
    std::vector<double> areas_at(const Vector &q) const;

    /// Of the nodes; in an increment those foreseen.
    const std::vector<double> &areas() const
    {
      return areas_.values();
    }

    /// The state is one that no increment led to.
    void update(const Vector &q);

    /// An increment was accepted.
    void accept(const Vector &q);

    /// See Blank::begin_increment().
    void begin_increment(double ratio);

    /// A saved state was taken.
    void renew();

    /// Every array of the state with its name.
    template <typename Surface, typename Action>
    static void each_array(Surface &surface, const Action &action)
    {
      ForeseenValues::each_array(surface.areas_, "area of nodes", action);
      if (!surface.at_nodes())
      {
        ForeseenValues::each_array(surface.point_areas_, "area of contact points", action);
        action("length of tangents", surface.meridian_.tangent_lengths());
      }
      each_flow_stress(surface, action);
    }

  private:
    /// Measure areas at @p q, and take them as @p take says.
    void measure(const Vector &q, void (ForeseenValues::*take)(std::vector<double>));

    /// Read where the contact points are.
    void read(Section &section);

    /// Where they are is known: the edges between nodes.
    void set_edges();

    std::vector<double> nodal_flow_stress(Side side) const override;
    unsigned int n_contact_nodes(Side side) const override;
    void nodal_point(const Vector &q, Side side, unsigned int node, ContactThickness thickness, ContactPoint &result)
      const override;
    FaceCurve face_curve(const Vector &q, Side, const unsigned int edge, const double xi) const override
    {
      return meridian_.curve(q, edge, xi);
    }
    double point_area(Side side, unsigned int point) const override;
    double area_at(const Vector &q, Side side, unsigned int edge, double xi) const override;

    /// Thickness of the sheet as contact meets it, at the place that @p result is.
    void set_thickness(ContactThickness thickness, ContactPoint &result) const;

    /// Of a node and between nodes, as asked for.
    ///@{
    double thickness_at_node(unsigned int node, ContactThickness thickness) const;
    double thickness_at(const ContactPoint &point, ContactThickness thickness) const;
    ///@}

    const ShellSpace &space_;
    const ShellPoints &points_;
    const ShellState &state_;
    ShellMeridian meridian_;
    NodalContact contact_point_;
    bool left_open_; ///< may contact points lie inside, and does the scene not say where they are?
    std::vector<std::array<unsigned int, 3>> edges_;
    NodeChain chain_;
    std::vector<double> angle_; ///< of the reference tangent at the nodes, averaged at kinks
    std::vector<bool> weightless_; ///< nodes whose tributary area vanishes: no contact
    ForeseenValues areas_; ///< of the nodes
    ForeseenValues point_areas_; ///< of the contact points between them
  };
} // namespace deltaform
