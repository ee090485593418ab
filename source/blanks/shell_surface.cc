#include "shell_surface.h"

#include <deltaform/parameters/section.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  ShellSurface::ShellSurface(Section &section,
                             const ShellSpace &space,
                             const ShellPoints &points,
                             const MaterialPoints &material,
                             const ShellState &state)
    : BlankSurface(material), space_(space), points_(points), state_(state), meridian_(space)
  {
    read(section);
    set_up();
  }


  void ShellSurface::set_up()
  {
    meridian_.set_up();
    // At a kink the contact director is the mean of its neighbours'; angles of one node differ by less than pi.
    angle_.assign(space_.n_nodes(), 0.);
    weightless_.assign(space_.n_nodes(), false);
    std::vector<unsigned int> count(space_.n_nodes(), 0);
    for (const auto &cell : space_.mesh().cells())
      for (unsigned int a = 0; a <= space_.degree(); ++a)
      {
        angle_[cell.nodes[a]] += cell.angle[a];
        ++count[cell.nodes[a]];
      }
    for (unsigned int i = 0; i < angle_.size(); ++i)
      angle_[i] /= count[i];

    const auto areas = space_.areas(Vector(space_.n_dofs()));
    for (unsigned int i = 0; i < areas.size(); ++i)
      weightless_[i] = areas[i] < 1e-9 * points_.node_weight(i);
    set_edges();
  }


  void ShellSurface::touch_inside(const bool move)
  {
    if (!left_open_)
      return;
    if (move)
      let_move();
    set_inside();
    set_edges();
  }


  void ShellSurface::set_edges()
  {
    edges_.clear();
    for (const auto &cell : space_.mesh().cells())
      if (at_nodes())
        edges_.push_back(cell.nodes);
      else if (space_.degree() == 1)
        edges_.push_back({{cell.nodes[0], cell.nodes[1], invalid_index}});
      else
      {
        edges_.push_back({{cell.nodes[0], cell.nodes[2], invalid_index}});
        edges_.push_back({{cell.nodes[2], cell.nodes[1], invalid_index}});
      }
    chain_.set_up(space_.n_nodes(), edges_);
    const Vector undeformed(space_.n_dofs());
    if (!at_nodes())
    {
      meridian_.update(undeformed);
      for (const Side side : {Side::bottom, Side::top})
        find_ends(side);
    }
    update(undeformed);
  }


  void ShellSurface::read(Section &section)
  {
    contact_point_ =
      section.choice("Contact point",
                     "normal offset",
                     {"normal offset", "outer fibre"},
                     "Where a node touches: half a thickness away along the tool's normal, or on the outer "
                     "fibre along the director (the force then has a moment).") == "normal offset"
        ? NodalContact::normal_offset
        : NodalContact::outer_fibre;
    if (space_.membrane() && contact_point_ == NodalContact::outer_fibre)
      section.fail("Contact point", "a membrane has no director: use 'normal offset'");

    const std::string choice = read_points(
      section,
      {10,
       16,
       "automatic",
       {"automatic", "nodes", "gauss", "moving"},
       "Which points touch: the nodes, or points inside the elements on the smooth curve through the nodes; with 3 and "
       "more of them the ends of the sheet touch as well; or one point in each element that moves to where it is "
       "deepest ('moving'): a sheet slides over a radius without being held by points that stand apart. automatic: "
       "inside, where the penalty factor of each is found "
       "(Enforcement = penalty, Penalty rule = adaptive), the sheet bends and 'Contact point' is the normal offset; in "
       "plane strain, and with 'Thickness compliance = off', for a delta of at least 1e-4 thickness only. moving: where "
       "they would be inside but for plane strain and a smaller delta, no tool has a force or another tool on its side, "
       "and supports hold the sheet at one place of its boundary at most. Else the nodes.",
       "Contact points inside an element, between two neighbouring nodes. With 2 the force of each is determinate; "
       "with 10 the face between them is little deeper than they are."},
      3);
    const bool possible = !space_.membrane() && contact_point_ == NodalContact::normal_offset;
    left_open_ = choice == "automatic" && possible;
    if ((choice != "gauss" && choice != "moving") || possible)
      return;
    section.fail("Contact points",
                 space_.membrane() ? "a membrane has no rotations that make its meridian smooth: use 'nodes'"
                                   : "points inside the elements touch at the 'normal offset' only: use 'nodes'");
  }


  unsigned int ShellSurface::n_contact_dofs() const
  {
    return space_.n_dofs();
  }


  unsigned int ShellSurface::n_nodes() const
  {
    return space_.n_nodes();
  }


  unsigned int ShellSurface::n_contact_nodes(Side) const
  {
    return space_.n_nodes();
  }


  std::vector<double> ShellSurface::nodal_flow_stress(const Side side) const
  {
    const unsigned int outer = side == Side::top ? points_.n_layers() - 1 : 0;
    std::vector<double> values(points_.size());
    for (unsigned int p = 0; p < values.size(); ++p)
      values[p] = material_.flow_stress(static_cast<std::size_t>(p) * points_.n_layers() + outer);
    return points_.to_nodes(values);
  }


  double ShellSurface::director_angle(const Vector &q, const unsigned int node) const
  {
    return space_.membrane() ? space_.chord_angle(q, node) : angle_[node] + space_.rotation(q, node);
  }


  double ShellSurface::thickness_at_node(const unsigned int node, const ContactThickness thickness) const
  {
    return thickness == ContactThickness::current   ? state_.face_thickness(node)
           : thickness == ContactThickness::initial ? points_.thickness()
                                                    : 0.;
  }


  double ShellSurface::thickness_at(const ContactPoint &point, const ContactThickness thickness) const
  {
    if (thickness != ContactThickness::current)
      return thickness_at_node(0, thickness);
    double h = 0.;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      h += point.nodes[a].share * state_.face_thickness(point.nodes[a].node);
    return h;
  }


  void ShellSurface::contact_place(const Vector &q,
                                   Side,
                                   const unsigned int edge,
                                   const double xi,
                                   const ContactThickness thickness,
                                   ContactPoint &result) const
  {
    meridian_.describe(q, edge, xi, result);
    set_thickness(thickness, result);
  }


  void ShellSurface::locate_place(const Vector &q,
                                  Side,
                                  const unsigned int edge,
                                  const double xi,
                                  const ContactThickness thickness,
                                  ContactPoint &result) const
  {
    meridian_.locate(q, edge, xi, result);
    set_thickness(thickness, result);
  }


  void ShellSurface::set_thickness(const ContactThickness thickness, ContactPoint &result) const
  {
    result.offset = .5 * thickness_at(result, thickness);
    result.thickness = thickness_at(result, ContactThickness::current);
    result.recovery = 0.;
    if (thickness == ContactThickness::current)
      for (unsigned int a = 0; a < result.n_nodes; ++a)
        result.recovery += result.nodes[a].share * state_.node_recovery(result.nodes[a].node);
    result.area = result.compliance = 0.;
  }


  double ShellSurface::largest_motion(Side,
                                      const unsigned int edge,
                                      const std::array<double, ContactPoint::max_dofs> &change) const
  {
    return meridian_.largest_motion(edge, change);
  }


  double ShellSurface::point_area(Side, const unsigned int point) const
  {
    return point_areas_.values()[point];
  }


  double ShellSurface::area_at(const Vector &q, Side, const unsigned int edge, const double xi) const
  {
    return meridian_.area(q, edge, xi);
  }


  void ShellSurface::nodal_point(const Vector &q,
                                 const Side side,
                                 const unsigned int node,
                                 const ContactThickness thickness,
                                 ContactPoint &result) const
  {
    const double h = thickness_at_node(node, thickness);
    result.set_node(node);
    std::copy_n(space_.dofs()[node].begin(), 3, result.dofs.begin());
    result.x = space_.position(q, node);
    result.area = areas_.values()[node];
    result.reference_coordinate = space_.mesh().nodes()[node][0];
    result.arc_coordinate = space_.mesh().arc_length()[node];
    result.thickness = state_.node_thickness(node);
    result.compliance = result.area > 0 ? .5 * h / (modulus() * result.area) : 0.;
    result.recovery = thickness == ContactThickness::current ? state_.node_recovery(node) : 0.;
    result.jacobian[0] = Tensor1({1., 0.});
    result.jacobian[1] = Tensor1({0., 1.});
    if (contact_point_ == NodalContact::normal_offset)
    {
      result.n_dofs = 2;
      result.offset = .5 * h;
      return;
    }
    const double theta = angle_[node] + space_.rotation(q, node);
    const double arm = side == Side::top ? .5 * h : -.5 * h;
    const Tensor1 d({-std::sin(theta), std::cos(theta)}), t({std::cos(theta), std::sin(theta)});
    result.n_dofs = 3;
    result.offset = 0.;
    result.x += arm * d;
    result.jacobian[2] = -arm * t;
    result.second[2] = -arm * d;
  }


  std::optional<ContactSurface::FaceDirection> ShellSurface::face_direction(const Vector &q,
                                                                            const Side side,
                                                                            const unsigned int point,
                                                                            const ContactThickness thickness) const
  {
    if (!at_nodes())
    {
      const unsigned int e = point / points_per_edge(), first = edges_[e][0], last = edges_[e][1];
      if (chain_.ends_at(first) || chain_.ends_at(last))
        return {};
      const Tensor1 rate = meridian_.rate(q, e, place_in_edge(side, point));
      const double growth = thickness_at_node(last, thickness) - thickness_at_node(first, thickness);
      return FaceDirection{rate / rate.norm(), .5 * growth / rate.norm()};
    }
    if (chain_.ends_at(point))
      return {};
    std::array<ContactPoint, 3> points;
    nodal_point(q, side, chain_.neighbours(point)[0], thickness, points[0]);
    nodal_point(q, side, point, thickness, points[1]);
    nodal_point(q, side, chain_.neighbours(point)[1], thickness, points[2]);
    return NodeChain::direction(points[0], points[1], points[2]);
  }


  const std::vector<std::array<unsigned int, 3>> &ShellSurface::contact_edges(Side) const
  {
    return edges_;
  }


  std::vector<double> ShellSurface::areas_at(const Vector &q) const
  {
    // The weight of a node on the axis vanishes for degree 2 in the initial configuration: it has no contact.
    std::vector<double> result = space_.areas(q);
    for (unsigned int i = 0; i < result.size(); ++i)
      if (weightless_[i])
        result[i] = 0.;
    return result;
  }


  void ShellSurface::update(const Vector &q)
  {
    measure(q, &ForeseenValues::reset);
  }


  void ShellSurface::accept(const Vector &q)
  {
    measure(q, &ForeseenValues::accept);
  }


  void ShellSurface::begin_increment(const double ratio)
  {
    areas_.begin_increment(ratio);
    point_areas_.begin_increment(ratio);
    foresee_flow_stress(ratio);
  }


  void ShellSurface::renew()
  {
    begin_increment(0.);
  }


  void ShellSurface::measure(const Vector &q, void (ForeseenValues::*const take)(std::vector<double>))
  {
    (areas_.*take)(areas_at(q));
    take_flow_stress(take);
    if (at_nodes())
      return;
    meridian_.update(q);
    (point_areas_.*take)(areas_of_points(q, Side::top));
  }
} // namespace deltaform
