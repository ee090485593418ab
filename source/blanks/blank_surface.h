#pragma once

#include "foreseen_values.h"
#include "material_points.h"

#include <deltaform/assembly/contact_surface.h>
#include <deltaform/parameters/section.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <string>
#include <vector>

namespace deltaform
{
  /// What the faces of all blanks have in common: the metal behind them, and contact points that are the nodes or lie
  /// inside the edges between them. They are Gauss points; where the face ends Lobatto points, so that the end touches; or
  /// one that moves.
  class BlankSurface : public ContactSurface
  {
  public:
    /// Do the nodes touch, or points inside the edges?
    bool at_nodes() const
    {
      return inner_.size() == 0;
    }

    unsigned int n_contact_points(Side side) const override;
    double modulus() const override;
    double flow_stress(Side side, unsigned int point) const override;

    /// See Blank::follow_flow_stress().
    void follow_flow_stress(Side side);

    void contact_point(const Vector &q,
                       Side side,
                       unsigned int point,
                       ContactThickness thickness,
                       ContactPoint &result) const override;
    void locate_point(const Vector &q,
                      Side side,
                      unsigned int point,
                      ContactThickness thickness,
                      ContactPoint &result) const override;
    unsigned int points_per_edge() const override;
    bool points_move() const override
    {
      return points_move_;
    }
    std::vector<dealii::Point<1>> points_of_edge(Side side, unsigned int edge) const override;
    double point_weight(Side side, unsigned int point) const override;
    void set_share(Side side, unsigned int point, ContactPoint &result) const override;

  protected:
    explicit BlankSurface(const MaterialPoints &material)
      : material_(material)
    {
    }

    struct GaussPoints
    {
      int default_number, most;
      std::string preset; ///< of the entry `Contact points`
      std::vector<std::string> choices; ///< of it
      std::string which, number; ///< what the scene's entries `Contact points` and `Gauss points` say
    };

    /// Read where the contact points are. @p degree of the polynomials that the places of an edge are. @return the
    /// choice
    std::string read_points(Section &section, const GaussPoints &offered, unsigned int degree);

    /// The contact points lie inside the edges, as many as was read, or as are left where they move.
    void set_inside();

    /// There is one point in each edge, which moves, once they lie inside.
    void let_move();

    /// The edges of @p side are there, or others than before.
    void find_ends(Side side);

    /// Take the flow stresses that are followed as @p take says.
    void take_flow_stress(void (ForeseenValues::*take)(std::vector<double>));

    /// See Blank::begin_increment().
    void foresee_flow_stress(double ratio);

    /// Every array of the state with its name: the flow stresses that are followed.
    template <typename Surface, typename Action>
    static void each_flow_stress(Surface &surface, const Action &action)
    {
      for (unsigned int side = 0; side < 2; ++side)
        if (surface.follows_[side])
          ForeseenValues::each_array(surface.flow_stress_[side],
                                     side == 0 ? "flow stress of the face, bottom" : "flow stress of the face, top",
                                     action);
    }

    /// Areas of the contact points of a side at @p q, if they lie inside the edges.
    std::vector<double> areas_of_points(const Vector &q, Side side) const;

    /// Where in its edge a contact point lies, from 0 to 1.
    double place_in_edge(const Side side, const unsigned int point) const
    {
      const unsigned int n = inner_.size();
      return rule(side, point / n).point(point % n)[0];
    }

    const MaterialPoints &material_;

  private:
    /// Accepted, at the contact points.
    std::vector<double> accepted_flow_stress(Side side) const;

    /// Accepted, at the nodes that may touch (stress).
    virtual std::vector<double> nodal_flow_stress(Side side) const = 0;

    virtual unsigned int n_contact_nodes(Side side) const = 0;

    /// Describe a node as contact point.
    virtual void nodal_point(const Vector &q,
                             Side side,
                             unsigned int node,
                             ContactThickness thickness,
                             ContactPoint &result) const = 0;

    /// Accepted, of a contact point inside an edge.
    virtual double point_area(Side side, unsigned int point) const = 0;

    /// Area per unit of xi at a place of an edge.
    virtual double area_at(const Vector &q, Side side, unsigned int edge, double xi) const = 0;

    /// Contact points of an edge, from 0 to 1 of it, and their weights.
    const dealii::Quadrature<1> &rule(const Side side, const unsigned int edge) const
    {
      return ends_[static_cast<unsigned int>(side)][edge] ? outer_ : inner_;
    }

    unsigned int n_inside_ = 0, degree_ = 0; ///< see read_points()
    bool points_move_ = false;
    dealii::Quadrature<1> inner_, outer_; ///< of an edge between others, of one where the face ends; empty: nodes touch
    std::array<bool, 2> follows_{{false, false}}; ///< see follow_flow_stress()
    std::array<ForeseenValues, 2> flow_stress_; ///< of the contact points of sides that are followed
    std::array<std::vector<bool>, 2> ends_; ///< does the face end at this edge? For each side
  };
} // namespace deltaform
