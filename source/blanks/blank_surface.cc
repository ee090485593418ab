#include "blank_surface.h"

#include <deltaform/parameters/section.h>

#include <deal.II/base/quadrature_lib.h>

#include <map>

namespace deltaform
{
  std::string BlankSurface::read_points(Section &section, const GaussPoints &offered, const unsigned int degree)
  {
    std::string choice = section.choice("Contact points", offered.preset, offered.choices, offered.which);
    n_inside_ = section.integer("Gauss points", offered.default_number, 1, offered.most, offered.number);
    degree_ = degree;
    if (choice == "moving")
      let_move();
    if (choice == "gauss" || points_move_)
      set_inside();
    return choice;
  }


  void BlankSurface::let_move()
  {
    points_move_ = true;
    n_inside_ = 1;
  }


  void BlankSurface::set_inside()
  {
    inner_ = outer_ = dealii::QGauss<1>(n_inside_);
    // Exact for a uniform pressure, or else it would not be met by equal pressures of the points.
    if (2 * n_inside_ >= degree_ + 3)
      outer_ = dealii::QGaussLobatto<1>(n_inside_);
  }


  void BlankSurface::find_ends(const Side side)
  {
    const auto &edges = contact_edges(side);
    std::map<unsigned int, unsigned int> n_edges; // that meet at a node
    for (const auto &[a, b, middle] : edges)
    {
      ++n_edges[a];
      ++n_edges[b];
    }
    const Vector undeformed(n_contact_dofs());
    auto &ends = ends_[static_cast<unsigned int>(side)];
    ends.assign(edges.size(), false);
    for (unsigned int e = 0; e < edges.size(); ++e)
      for (const unsigned int end : {0, 1})
        // On the axis the face does not end.
        if (n_edges[edges[e][end]] == 1 && area_at(undeformed, side, e, end) > 0.)
          ends[e] = true;
  }


  std::vector<double> BlankSurface::areas_of_points(const Vector &q, const Side side) const
  {
    std::vector<double> result;
    for (unsigned int e = 0; e < contact_edges(side).size(); ++e)
    {
      const auto &points = rule(side, e);
      for (unsigned int g = 0; g < points.size(); ++g)
        result.push_back(points.weight(g) * area_at(q, side, e, points.point(g)[0]));
    }
    return result;
  }


  unsigned int BlankSurface::n_contact_points(const Side side) const
  {
    return at_nodes() ? n_contact_nodes(side) : contact_edges(side).size() * inner_.size();
  }


  double BlankSurface::modulus() const
  {
    return material_.law().young_modulus();
  }


  double BlankSurface::flow_stress(const Side side, const unsigned int point) const
  {
    return flow_stress_[static_cast<unsigned int>(side)].values()[point];
  }


  void BlankSurface::follow_flow_stress(const Side side)
  {
    follows_[static_cast<unsigned int>(side)] = true;
    flow_stress_[static_cast<unsigned int>(side)].reset(accepted_flow_stress(side));
  }


  void BlankSurface::take_flow_stress(void (ForeseenValues::*const take)(std::vector<double>))
  {
    for (const Side side : {Side::bottom, Side::top})
      if (follows_[static_cast<unsigned int>(side)])
        (flow_stress_[static_cast<unsigned int>(side)].*take)(accepted_flow_stress(side));
  }


  void BlankSurface::foresee_flow_stress(const double ratio)
  {
    for (auto &values : flow_stress_)
      values.begin_increment(ratio);
  }


  std::vector<double> BlankSurface::accepted_flow_stress(const Side side) const
  {
    std::vector<double> values = nodal_flow_stress(side);
    if (at_nodes())
      return values;
    std::vector<double> result;
    const auto &edges = contact_edges(side);
    for (unsigned int e = 0; e < edges.size(); ++e)
      for (const auto &xi : rule(side, e).get_points())
        result.push_back((1. - xi[0]) * values[edges[e][0]] + xi[0] * values[edges[e][1]]);
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
    contact_place(q, side, point / inner_.size(), place_in_edge(side, point), thickness, result);
    set_share(side, point, result);
  }


  void BlankSurface::locate_point(const Vector &q,
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
    locate_place(q, side, point / inner_.size(), place_in_edge(side, point), thickness, result);
    set_share(side, point, result);
  }


  void BlankSurface::set_share(const Side side, const unsigned int point, ContactPoint &result) const
  {
    result.area = point_area(side, point);
    result.compliance = result.offset > 0. ? result.offset / (modulus() * result.area) : 0.;
  }


  unsigned int BlankSurface::points_per_edge() const
  {
    return inner_.size();
  }


  std::vector<dealii::Point<1>> BlankSurface::points_of_edge(const Side side, const unsigned int edge) const
  {
    return rule(side, edge).get_points();
  }


  double BlankSurface::point_weight(const Side side, const unsigned int point) const
  {
    const unsigned int n = inner_.size();
    return rule(side, point / n).weight(point % n);
  }
} // namespace deltaform
