#pragma once

#include "material_points.h"

#include <deltaform/assembly/contact_surface.h>
#include <deltaform/parameters/section.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// What the faces of all blanks have in common: the metal behind them, and contact points that are the nodes or Gauss
  /// points of the edges between them.
  class BlankSurface : public ContactSurface
  {
  public:
    unsigned int n_contact_points(Side side) const override;
    double modulus() const override;
    std::vector<double> flow_stress(Side side) const override;
    void contact_point(const Vector &q,
                       Side side,
                       unsigned int point,
                       ContactThickness thickness,
                       ContactPoint &result) const override;
    unsigned int points_per_edge() const override;

  protected:
    explicit BlankSurface(const MaterialPoints &material)
      : material_(material)
    {
    }

    struct GaussPoints
    {
      int default_number, most;
      std::string which, number; ///< what the scene's entries `Contact points` and `Gauss points` say
    };

    /// Read where the contact points are.
    void read_points(Section &section, const GaussPoints &offered);

    bool at_nodes() const
    {
      return rule_.empty();
    }

    const MaterialPoints &material_;
    std::vector<dealii::Point<1>> rule_; ///< contact points of an edge; none: the nodes are
    std::vector<double> weights_; ///< of the rule

  private:
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
  };
} // namespace deltaform
