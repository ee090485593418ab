#pragma once

#include "material_points.h"
#include "shell_meridian.h"
#include "shell_points.h"
#include "shell_space.h"
#include "shell_state.h"

#include <deltaform/assembly/contact_surface.h>

#include <array>
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
  class ShellSurface : public ContactSurface
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
    unsigned int n_contact_points(Side side) const override;
    double modulus() const override;
    std::vector<double> flow_stress(Side side) const override;
    void contact_point(const Vector &q,
                       Side side,
                       unsigned int node,
                       ContactThickness thickness,
                       ContactPoint &result) const override;
    const std::vector<std::array<unsigned int, 3>> &contact_edges(Side side) const override;
    unsigned int points_per_edge() const override;
    void contact_place(const Vector &q,
                       Side side,
                       unsigned int edge,
                       double xi,
                       ContactThickness thickness,
                       ContactPoint &result) const override;

    /// Angle of the director, of a membrane that of the meridian.
    double director_angle(const Vector &q, unsigned int node) const;

    /// Tributary areas of the nodes at @p q; zero for those that never have one.
    std::vector<double> areas_at(const Vector &q) const;

    /// Accepted.
    const std::vector<double> &areas() const
    {
      return areas_;
    }

    /// An increment was accepted.
    void update(const Vector &q);

    /// Every array of the state with its name.
    template <typename Surface, typename Action>
    static void each_array(Surface &surface, const Action &action)
    {
      action("area of nodes", surface.areas_);
      if (!surface.rule_.empty())
      {
        action("area of contact points", surface.point_areas_);
        action("length of tangents", surface.meridian_.tangent_lengths());
      }
    }

  private:
    /// Read where the contact points are.
    void read(Section &section);

    /// Describe a node as contact point.
    void nodal_point(const Vector &q, Side side, unsigned int node, ContactThickness thickness, ContactPoint &result)
      const;

    /// Between nodes, as asked for.
    double thickness_at(const ContactPoint &point, ContactThickness thickness) const;

    const ShellSpace &space_;
    const ShellPoints &points_;
    const MaterialPoints &material_;
    const ShellState &state_;
    ShellMeridian meridian_;
    NodalContact contact_point_;
    std::vector<dealii::Point<1>> rule_; ///< contact points of a piece of the meridian; none: the nodes are
    std::vector<double> weights_; ///< of the rule
    std::vector<std::array<unsigned int, 3>> edges_;
    std::vector<double> angle_; ///< of the reference tangent at the nodes, averaged at kinks
    std::vector<bool> weightless_; ///< nodes whose tributary area vanishes: no contact
    std::vector<double> areas_;
    std::vector<double> point_areas_; ///< of the contact points between nodes
  };
} // namespace deltaform
