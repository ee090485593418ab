#include "solid_surface.h"

#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  SolidSurface::SolidSurface(Section &section,
                             const SolidDiscretization &body,
                             const MaterialPoints &material,
                             const bool moves)
    : BlankSurface(material), body_(body), moves_(moves),
      parts_{{section.names("Contact bottom",
                            "bottom",
                            "Parts of the boundary that tools with Side = bottom touch; 'bottom, end' goes around the "
                            "corner."),
              section.names("Contact top", "top", "Parts of the boundary that tools with Side = top touch.")}},
      faces_{{SolidFace(body.space()), SolidFace(body.space())}}
  {
    left_open_ =
      read_points(
        section,
        {20,
         32,
         "automatic",
         {"automatic", "nodes", "gauss"},
         "Which points touch: the nodes, or Gauss points of the edges of the cells. automatic: Gauss points, where the "
         "penalty factor of each is found (Enforcement = penalty, Penalty rule = adaptive) for a delta of at least "
         "1e-4 edge, with finite strain and in one process; else the nodes.",
         "Contact points of an edge. With as many as the degree of the cells the force of each is determinate; with 20 "
         "the face between them is little deeper than they are."},
        body_.space().degree()) == "automatic";
  }


  void SolidSurface::touch_inside()
  {
    if (!left_open_)
      return;
    set_inside();
    for (const Side side : {Side::bottom, Side::top})
      find_ends(side);
    update(Vector(n_contact_dofs()));
  }


  void SolidSurface::set_up(const Section &section)
  {
    const SolidMesh &mesh = body_.space().mesh();
    for (const auto &[entry, side] : {std::pair("Contact bottom", 0), std::pair("Contact top", 1)})
    {
      std::vector<std::string> there;
      for (const auto &name : parts_[side])
        if (body_.boundary().has(name))
          there.push_back(name);
        else if (section.given(entry) || mesh.is_strip())
          section.fail(entry,
                       "there is no boundary '" + name + "'; there are " + text::join(mesh.boundaries(), ", "));
      parts_[side] = there;
    }
    for (unsigned int side = 0; side < 2; ++side)
    {
      faces_[side].set_up(body_.boundary(), parts_[side]);
      if (!at_nodes())
        find_ends(static_cast<Side>(side));
    }
    shortest_edge_ = std::min(faces_[0].shortest_edge(), faces_[1].shortest_edge());
    if (!std::isfinite(shortest_edge_))
      shortest_edge_ = mesh.thickness();
    for (auto &face : faces_)
      face.set_up_areas(shortest_edge_);
    update(Vector(n_contact_dofs()));
  }


  void SolidSurface::set_up()
  {
    for (unsigned int side = 0; side < 2; ++side)
    {
      faces_[side].set_up(body_.boundary(), parts_[side]);
      if (!at_nodes())
        find_ends(static_cast<Side>(side));
      faces_[side].set_up_areas(shortest_edge_);
    }
  }


  void SolidSurface::update(const Vector &q)
  {
    measure(q, &ForeseenValues::reset);
  }


  void SolidSurface::accept(const Vector &q)
  {
    measure(q, &ForeseenValues::accept);
  }


  void SolidSurface::begin_increment(const double ratio)
  {
    for (unsigned int side = 0; side < 2; ++side)
    {
      faces_[side].areas().begin_increment(ratio);
      point_areas_[side].begin_increment(ratio);
    }
    foresee_flow_stress(ratio);
  }


  void SolidSurface::renew()
  {
    begin_increment(0.);
  }


  void SolidSurface::measure(const Vector &q, void (ForeseenValues::*const take)(std::vector<double>))
  {
    const Vector none(q.size());
    for (unsigned int side = 0; side < 2; ++side)
    {
      SolidFace &face = faces_[side];
      (face.areas().*take)(face.areas_at(moves_ ? q : none));
      if (!at_nodes())
        (point_areas_[side].*take)(areas_of_points(moves_ ? q : none, static_cast<Side>(side)));
    }
    take_flow_stress(take);

    const SolidSpace &space = body_.space();
    smallest_thickness_ = std::numeric_limits<double>::infinity();
    for (const auto &[bottom, top] : body_.boundary().columns())
      smallest_thickness_ = std::min(smallest_thickness_, space.position(q, top).distance(space.position(q, bottom)));
    if (body_.boundary().columns().empty())
    {
      for (const auto node : faces_[1].nodes())
        smallest_thickness_ = std::min(smallest_thickness_, faces_[0].distance(q, space.position(q, node)));
      if (!std::isfinite(smallest_thickness_))
        smallest_thickness_ = space.mesh().thickness();
    }
  }


  FacePoints SolidSurface::points(const Side side) const
  {
    const SolidFace &own = face(static_cast<unsigned int>(side));
    FacePoints result{own.places(), own.edges(), {}};
    if (!at_nodes())
      for (unsigned int e = 0; e < own.edges().size(); ++e)
      {
        result.inside.emplace_back();
        for (const auto &point : points_of_edge(side, e))
          result.inside.back().push_back(point[0]);
      }
    return result;
  }


  unsigned int SolidSurface::n_contact_dofs() const
  {
    return body_.space().hanging().n_unknowns();
  }


  unsigned int SolidSurface::n_nodes() const
  {
    return body_.space().nodes().size();
  }


  double SolidSurface::largest_motion(Side,
                                      unsigned int,
                                      const std::array<double, ContactPoint::max_dofs> &change) const
  {
    double square = 0.;
    for (unsigned int k = 0; k <= 2 * body_.space().degree(); k += 2)
      square = std::max(square, change[k] * change[k] + change[k + 1] * change[k + 1]);
    // The sum of the absolute shape functions of a parabola is 5/4 at most, at its quarters.
    return (body_.space().degree() == 1 ? 1. : 1.25) * std::sqrt(square);
  }


  unsigned int SolidSurface::n_contact_nodes(const Side side) const
  {
    return face(static_cast<unsigned int>(side)).nodes().size();
  }


  std::vector<double> SolidSurface::nodal_flow_stress(const Side side) const
  {
    std::vector<double> values(material_.size());
    for (unsigned int p = 0; p < values.size(); ++p)
      values[p] = material_.flow_stress(p);
    values = body_.points().to_nodes(values);
    std::vector<double> result;
    for (const auto node : face(static_cast<unsigned int>(side)).nodes())
      result.push_back(values[node]);
    return result;
  }


  void SolidSurface::nodal_point(const Vector &q,
                                 const Side side,
                                 const unsigned int node,
                                 ContactThickness,
                                 ContactPoint &result) const
  {
    faces_[static_cast<unsigned int>(side)].contact_point(q, node, result);
    result.thickness = shortest_edge_;
  }


  double SolidSurface::point_area(const Side side, const unsigned int point) const
  {
    return point_areas_[static_cast<unsigned int>(side)].values()[point];
  }


  double SolidSurface::area_at(const Vector &q, const Side side, const unsigned int edge, const double xi) const
  {
    ContactPoint place;
    faces_[static_cast<unsigned int>(side)].contact_place(q, edge, xi, place);
    return place.area;
  }


  void SolidSurface::contact_place(const Vector &q,
                                   const Side side,
                                   const unsigned int edge,
                                   const double xi,
                                   ContactThickness,
                                   ContactPoint &result) const
  {
    faces_[static_cast<unsigned int>(side)].contact_place(q, edge, xi, result);
    result.thickness = shortest_edge_;
    result.area = 0.;
  }


  const std::vector<std::array<unsigned int, 3>> &SolidSurface::contact_edges(const Side side) const
  {
    return faces_[static_cast<unsigned int>(side)].edges();
  }
} // namespace deltaform
