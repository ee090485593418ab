#include "blank_surface.h"

#include <deal.II/base/quadrature_lib.h>

namespace deltaform
{
  void BlankSurface::read_points(Section &section, const GaussPoints &offered)
  {
    const bool inside = section.choice("Contact points", "nodes", {"nodes", "gauss"}, offered.which) == "gauss";
    const int n_points = section.integer("Gauss points", offered.default_number, 1, offered.most, offered.number);
    if (!inside)
      return;
    const dealii::QGauss<1> rule(n_points);
    rule_ = rule.get_points();
    weights_ = rule.get_weights();
  }


  unsigned int BlankSurface::n_contact_points(const Side side) const
  {
    return at_nodes() ? n_contact_nodes(side) : contact_edges(side).size() * rule_.size();
  }


  double BlankSurface::modulus() const
  {
    return material_.law().young_modulus();
  }


  std::vector<double> BlankSurface::flow_stress(const Side side) const
  {
    const std::vector<double> values = nodal_flow_stress(side);
    if (at_nodes())
      return values;
    std::vector<double> result;
    for (const auto &[a, b, middle] : contact_edges(side))
      for (const auto &xi : rule_)
        result.push_back((1. - xi[0]) * values[a] + xi[0] * values[b]);
    return result;
  }


  void BlankSurface::contact_point(const Vector &q,
                                   const Side side,
                                   const unsigned int point,
                                   const ContactThickness thickness,
                                   ContactPoint &result) const
  {
    if (at_nodes())
    {
      nodal_point(q, side, point, thickness, result);
      return;
    }
    const unsigned int n = rule_.size();
    contact_place(q, side, point / n, rule_[point % n][0], thickness, result);
    result.area = point_area(side, point);
    result.compliance = result.offset > 0. ? result.offset / (modulus() * result.area) : 0.;
  }


  unsigned int BlankSurface::points_per_edge() const
  {
    return rule_.size();
  }
} // namespace deltaform
