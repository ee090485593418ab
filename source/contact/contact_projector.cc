#include <deltaform/contact/contact_projector.h>
#include <deltaform/parameters/section.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  ContactProjector::ContactProjector(const ContactSurface &surface,
                                     const Side side,
                                     const Counterpart &counterpart,
                                     Section &section)
    : surface_(surface), side_(side), counterpart_(counterpart)
  {
    const std::string thickness =
      section.choice("Contact thickness",
                     "current",
                     {"current", "initial", "none"},
                     "Thickness of a shell in contact. current: of the last accepted increment. initial: for a "
                     "tool at a fixed gap to another. none: contact at the mid-surface.");
    thickness_ = thickness == "current"   ? ContactThickness::current
                 : thickness == "initial" ? ContactThickness::initial
                                          : ContactThickness::none;
    gives_way_ = reads_compliance(section);
    reset();
  }


  bool ContactProjector::reads_compliance(Section &section)
  {
    return section.choice("Thickness compliance",
                          "on",
                          {"on", "off"},
                          "Elasticity of a shell through its thickness. on: the half on this tool's side is an elastic "
                          "spring that the contact pressure compresses. off: it is rigid within an increment.") == "on";
  }


  void ContactProjector::describe(const Vector &q, const unsigned int i, ContactPoint &point) const
  {
    if (moving_.used())
    {
      surface_.contact_place(q, side_, i, moving_.place(i), thickness_, point);
      set_moving(i, moving_.place(i), point);
      return;
    }
    surface_.contact_point(q, side_, i, thickness_, point);
    flat_.describe(surface_, side_, i, point);
    release_face(point);
  }


  void ContactProjector::set_moving(const unsigned int i, const double xi, ContactPoint &point) const
  {
    surface_.set_share(side_, i, point);
    release_face(point);
    point.offset += moving_.lift(i, xi);
  }


  ContactPoint ContactProjector::start(const unsigned int i) const
  {
    ContactPoint result;
    if (moving_.used())
    {
      surface_.locate_place(far_.start(), side_, i, moving_.accepted(i), thickness_, result);
      set_moving(i, moving_.accepted(i), result);
    }
    else
      locate(far_.start(), i, result);
    result.x -= far_.start_shift();
    return result;
  }


  ContactPoint
  ContactProjector::accepted_point(const Vector &q, const unsigned int i, const FlatEdges::Points &accepted) const
  {
    if (moving_.used())
      return point(q, i);
    ContactPoint result;
    surface_.contact_point(q, side_, i, thickness_, result);
    // Of an edge that bore nothing the accepted points may have been put down since, each with its own area.
    const unsigned int e = i / group(), first = e * group(), last = first + group() - 1;
    if (FlatEdges::was_flat(accepted, group(), e) && (accepted[first].touching || accepted[last].touching))
      FlatEdges::describe_on_flat(surface_, side_, i, result);
    release_face(result);
    return result;
  }


  void ContactProjector::locate(const Vector &q, const unsigned int i, ContactPoint &point) const
  {
    if (moving_.used())
    {
      surface_.locate_place(q, side_, i, moving_.place(i), thickness_, point);
      set_moving(i, moving_.place(i), point);
      return;
    }
    surface_.locate_point(q, side_, i, thickness_, point);
    flat_.describe(surface_, side_, i, point);
    release_face(point);
  }


  void ContactProjector::locate(const Vector &q, const unsigned int edge, const double xi, ContactPoint &place) const
  {
    surface_.locate_place(q, side_, edge, xi, thickness_, place);
    release_face(place);
  }


  void ContactProjector::release_face(ContactPoint &point) const
  {
    if (gives_way_)
      point.offset += point.recovery;
    else
      point.compliance = 0.;
  }


  ContactPoint ContactProjector::place(const Vector &q, const unsigned int edge, const double xi) const
  {
    ContactPoint result;
    surface_.contact_place(q, side_, edge, xi, thickness_, result);
    release_face(result);
    return result;
  }


  Projection ContactProjector::project(const unsigned int i, const Point2 &x)
  {
    Last &last = last_[i];
    const Projection projection = counterpart_.project(x, last.segment);
    last.segment = projection.segment;
    last.place = x;
    last.distance = std::isfinite(projection.distance) ? projection.distance : -1.;
    return projection;
  }


  double ContactProjector::slope(const Vector &q, const unsigned int i, const Projection &closest) const
  {
    const auto face = surface_.face_direction(q, side_, i, thickness_);
    if (!face)
      return 0.;
    Tensor1 along = face->along;
    if (moving_.used())
    {
      along = surface_.face_curve(q, side_, i, moving_.place(i)).along;
      along /= along.norm();
    }
    const double rise = closest.normal * along - face->offset_rate;
    return closest.tangent * along < 0. ? -rise : rise;
  }


  std::pair<unsigned int, double> ContactProjector::closest(const Vector &q, const Tensor1 &way) const
  {
    std::pair<unsigned int, double> result(invalid_index, std::numeric_limits<double>::infinity());
    for (unsigned int i = 0; i < last_.size(); ++i)
    {
      const ContactPoint description = point(q, i);
      if (!(description.area > 0))
        continue;
      const double gap = counterpart_.project(description.x - way).distance - description.offset;
      if (gap < result.second)
        result = {i, gap};
    }
    return result;
  }


  void ContactProjector::leave(const std::vector<EdgeClearance> &edges)
  {
    far_.add(edges);
    for (const EdgeClearance &edge : edges)
      flat_.discard(edge.edge);
  }


  void ContactProjector::discard_distances()
  {
    for (auto &last : last_)
      last.distance = -1.;
  }


  void ContactProjector::renumber(const std::vector<PointOrigin> &origins, const std::vector<bool> &flat)
  {
    std::vector<Last> renumbered(origins.size());
    for (unsigned int i = 0; i < origins.size(); ++i)
      renumbered[i].segment = last_[origins[i].first].segment;
    last_ = renumbered;
    flat_.set(flat);
    moving_.reset(surface_.points_move() ? edges() : std::vector<std::array<unsigned int, 3>>());
    look_at_all();
  }


  void ContactProjector::reset()
  {
    last_.assign(n_points(), Last());
    flat_.set({});
    moving_.reset(surface_.points_move() ? edges() : std::vector<std::array<unsigned int, 3>>());
    look_at_all();
  }
} // namespace deltaform
