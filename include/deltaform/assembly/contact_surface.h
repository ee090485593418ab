#pragma once

#include <deltaform/assembly/contact_point.h>
#include <deltaform/assembly/side.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace deltaform
{
  /// The faces of a blank as contact sees them: points, and edges between nodes.
  class ContactSurface
  {
  public:
    virtual ~ContactSurface() = default;

    /// Number of unknowns that positions may depend on.
    virtual unsigned int n_contact_dofs() const = 0;

    /// Of the blank.
    virtual unsigned int n_nodes() const = 0;

    virtual unsigned int n_contact_points(Side side) const = 0;

    /// Young's modulus of the body behind the surface (stress).
    virtual double modulus() const = 0;

    /// Flow stress of the material at a contact point (stress), in an increment the one foreseen for its end; infinite
    /// where it is elastic. Known once Blank::follow_flow_stress() has asked for it.
    virtual double flow_stress(Side side, unsigned int point) const = 0;

    /// Describe contact point @p point of one side at @p q.
    virtual void contact_point(const Vector &q,
                               Side side,
                               unsigned int point,
                               ContactThickness thickness,
                               ContactPoint &result) const = 0;

    /// Describe where it is: as contact_point(), but the row over the unknowns and the coordinates on the undeformed
    /// blank are unspecified. It is asked for at every point, touching or not.
    virtual void locate_point(const Vector &q,
                              const Side side,
                              const unsigned int point,
                              const ContactThickness thickness,
                              ContactPoint &result) const
    {
      contact_point(q, side, point, thickness, result);
    }

    /// Nodes of each edge along the side: its ends, then a middle node (invalid_index: none). Where the nodes are the
    /// contact points, the face between them is interpolated by Lagrange polynomials.
    virtual const std::vector<std::array<unsigned int, 3>> &contact_edges(Side side) const = 0;

    /// Points inside an edge: those of edge e have the numbers e n to e n + n - 1. 0: the nodes are the contact points.
    virtual unsigned int points_per_edge() const
    {
      return 0;
    }

    /// Where they lie, from 0 to 1 along an edge.
    virtual std::vector<dealii::Point<1>> points_of_edge(Side /*side*/, unsigned int /*edge*/) const
    {
      return {};
    }

    /// Does the one point of each edge move to where it is deepest (MovingPoints)?
    virtual bool points_move() const
    {
      return false;
    }

    /// Their shares of its length.
    virtual double point_weight(Side /*side*/, unsigned int /*point*/) const
    {
      return 1.;
    }

    /// Where contact points lie inside the edges: describe any place of an edge, @p xi from 0 to 1. Its area is 0.
    virtual void contact_place(const Vector & /*q*/,
                               Side /*side*/,
                               unsigned int /*edge*/,
                               double /*xi*/,
                               ContactThickness /*thickness*/,
                               ContactPoint & /*result*/) const
    {
      Assert(false, dealii::ExcPureFunctionCalled());
    }

    /// Where it is, in the same way as locate_point().
    virtual void locate_place(const Vector &q,
                              const Side side,
                              const unsigned int edge,
                              const double xi,
                              const ContactThickness thickness,
                              ContactPoint &result) const
    {
      contact_place(q, side, edge, xi, thickness, result);
    }

    /// Set what belongs to contact point @p point and not to its place in the edge: area and compliance. @p result: the
    /// place.
    virtual void set_share(Side /*side*/, unsigned int /*point*/, ContactPoint & /*result*/) const
    {
      Assert(false, dealii::ExcPureFunctionCalled());
    }

    /// The curve x(xi) of an edge at a place.
    struct FaceCurve
    {
      Tensor1 along, bend; ///< dx/dxi, d2x/dxi2
      std::array<Tensor1, ContactPoint::max_dofs> jacobian{}; ///< d(dx/dxi)/dq of the unknowns of the place
    };

    /// Where contact points move.
    virtual FaceCurve face_curve(const Vector & /*q*/, Side /*side*/, unsigned int /*edge*/, double /*xi*/) const
    {
      Assert(false, dealii::ExcPureFunctionCalled());
      return {};
    }

    /// The face at a contact point.
    struct FaceDirection
    {
      Tensor1 along; ///< unit vector along the curve that the offset is added to
      double offset_rate; ///< d offset/d length of the curve
    };

    /// None: at an end of the face, which may rest on a tool at any angle, or of a face that does not tell.
    virtual std::optional<FaceDirection>
    face_direction(const Vector & /*q*/, Side /*side*/, unsigned int /*point*/, ContactThickness /*thickness*/) const
    {
      return {};
    }

    /// Where contact points lie inside the edges: an upper bound of how far any place of an edge moves (length) if the
    /// unknowns of its points change by @p change, in the order in which one of them names them. Infinite: none is
    /// known.
    virtual double largest_motion(Side /*side*/,
                                  unsigned int /*edge*/,
                                  const std::array<double, ContactPoint::max_dofs> & /*change*/) const
    {
      return std::numeric_limits<double>::infinity();
    }
  };
} // namespace deltaform
