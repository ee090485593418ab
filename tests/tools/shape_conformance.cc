#include "../conformance.h"

#include <deltaform/geometry/curvature.h>
#include <deltaform/parameters/section.h>
#include <deltaform/tools/shape.h>

#include <functional>
#include <random>

// What every registered shape must do, whatever it looks like.

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  // Two shapes without a right angle, of everything that may be in a profile, for the loops below.
  struct Zigzag : Shape
  {
    explicit Zigzag(Section &)
    {
      build({{-1.7, -1.1}, {-1.1, .3}, {.2, .7}, {.6, -.6}, {1.3, -.4}, {1.9, .9}, {2.6, .2}, {2.9, -1.3}},
            {0., .3, 0., .25, .2, 0., .4, 0.});
    }
  };

  struct Rotor : Shape // nothing but arcs
  {
    explicit Rotor(Section &)
    {
      std::vector<Point2> corners;
      for (unsigned int i = 0; i < 7; ++i)
        corners.emplace_back(std::cos(.3 - i * 2 * 3.14159265358979 / 7), std::sin(.3 - i * 2 * 3.14159265358979 / 7));
      build_closed(corners, std::vector<double>(7, std::cos(3.14159265358979 / 7) * (1 - 1e-14)));
    }
  };

  const Registry<Shape>::Entry zigzag("zigzag (test)", "Lines, fillets, corners and dents", make_as<Zigzag, Shape>);
  const Registry<Shape>::Entry rotor("rotor (test)", "Arcs only", make_as<Rotor, Shape>);

  constexpr unsigned int n_points = 10000;

  std::unique_ptr<Shape> make(const std::string &name, const Entries &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    return Registry<Shape>::make(name, section);
  }

  /// Every registered shape with the values of the documentation, and with others.
  void for_all_shapes(const std::function<void(const Shape &)> &body)
  {
    BOOST_TEST_REQUIRE(!Registry<Shape>::names().empty());
    for (const std::string &name : Registry<Shape>::names())
      BOOST_TEST_CONTEXT("shape '" << name << "'")
      {
        const Entries documented = documented_entries([&](ParameterTree &tree) {
          Section section = tree.root();
          Registry<Shape>::make(name, section);
        });
        const auto make_shape = [&](const Entries &entries) { return make(name, entries); };
        const auto check = [&](const Entries &entries) { body(*make_shape(entries)); };
        if (name != "plate")
          with_two_sets(documented, make_shape, check);
        else // the documented one has no end
        {
          check(documented);
          check(documented + Entries{"Inner radius=.3", "Outer radius=1.7", "Edge radius=.2"});
        }
      }
  }

  // Returns whether the point was fit for the check.
  using Check = std::function<bool(const Shape &, const Point2 &, const Projection &)>;

  // Calls the check for random points around every registered shape that have a closest point.
  void for_all(const Check &check)
  {
    for_all_shapes([&](const Shape &shape) {
      Point2 lower(-1., -1.), upper(1., 1.);
      for (const Point2 &point : shape.polyline())
        for (unsigned int d = 0; d < 2; ++d)
        {
          lower[d] = std::min(lower[d], 1.5 * point[d]);
          upper[d] = std::max(upper[d], 1.5 * point[d]);
        }
      std::mt19937 generator(20);
      std::uniform_real_distribution<double> r(lower[0], upper[0]), z(lower[1], upper[1]);
      unsigned int n_checked = 0;
      for (unsigned int i = 0; i < n_points; ++i)
      {
        const Point2 x(r(generator), z(generator));
        const Projection p = shape.project(x);
        if (std::isfinite(p.distance) && check(shape, x, p))
          ++n_checked;
      }
      BOOST_TEST(n_checked > n_points / 10);
    });
  }

  // A step of the differences along r and z.
  std::array<Tensor1, 2> steps(const double h)
  {
    return {{Tensor1({h, 0.}), Tensor1({0., h})}};
  }

  // Seen by the points of the polyline alone.
  bool another_is_closer(const Shape &shape, const Point2 &x, const double distance)
  {
    for (const Point2 &point : shape.polyline(1e-3))
      if (point.distance(x) < distance * (1 - 1e-6) - 1e-12)
        return true;
    return false;
  }

  // Not near an arc's center, a segment's end or the tool's skeleton, where derivatives do not exist or jump.
  bool is_smooth(const Shape &shape, const Point2 &x, const Projection &p, const double step)
  {
    if (std::abs(p.curvature) > 20.)
      return false;
    for (const double sign : {-1., 1.})
      for (const Tensor1 &direction : {p.normal, p.tangent})
      {
        const Projection q = shape.project(x + 3. * sign * step * direction);
        if (!std::isfinite(q.distance) || q.segment != p.segment || (q.normal - p.normal).norm() > 200. * step)
          return false;
      }
    return true;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(shape_conformance)

BOOST_AUTO_TEST_CASE(normal_and_tangent_are_a_frame)
{
  for_all(
    [](const Shape &, const Point2 &, const Projection &p) {
      BOOST_TEST_REQUIRE(std::abs(p.normal.norm() - 1) < 1e-14);
      BOOST_TEST_REQUIRE(std::abs(p.tangent.norm() - 1) < 1e-14);
      BOOST_TEST_REQUIRE(std::abs(p.normal[0] + p.tangent[1]) < 1e-15); // the tangent turned by +90 degrees
      BOOST_TEST_REQUIRE(std::abs(p.normal[1] - p.tangent[0]) < 1e-15);
      return true;
    });
}

BOOST_AUTO_TEST_CASE(material_above_is_outside)
{
  // Walked with growing r, the blank to the left: what lies above the whole tool is outside. A shape walked backwards
  // has it inside.
  for_all_shapes([](const Shape &shape) {
    std::mt19937 generator(21);
    std::uniform_real_distribution<double> part(0., 1.);
    const auto box = shape.bounding_box();
    unsigned int n_checked = 0;
    double first_r = 1e300, last_r = -1e300;
    for (const Point2 &point : shape.polyline())
    {
      first_r = std::min(first_r, point[0]);
      last_r = std::max(last_r, point[0]);
    }
    for (unsigned int i = 0; i < 200; ++i)
    {
      const Point2 x(first_r + (last_r - first_r) * part(generator), box.second[1] + 1e-3 + 2 * part(generator));
      const double distance = shape.project(x).distance;
      BOOST_TEST_REQUIRE(distance > 0.);
      n_checked += std::isfinite(distance);
    }
    BOOST_TEST(n_checked > 100u);
  });
}

BOOST_AUTO_TEST_CASE(named_shapes_touch_first_at_their_origin_s_height)
{
  // So that Position z is where the tool's surface begins. A circle's position is its center; a profile stands where
  // its points are; shapes of tests may be anything.
  unsigned int n_checked = 0;
  for (const std::string &name : Registry<Shape>::names())
    BOOST_TEST_CONTEXT("shape '" << name << "'")
    {
      ParameterTree tree = ParameterTree::documentation();
      Section section = tree.root();
      const auto shape = Registry<Shape>::make(name, section);
      const bool test = name.size() > 6 && name.compare(name.size() - 6, 6, "(test)") == 0;
      if (test || shape->in_scene_frame() || name == "circle")
        continue;
      BOOST_TEST_REQUIRE(std::abs(shape->bounding_box().second[1]) < 1e-12);
      ++n_checked;
    }
  BOOST_TEST_REQUIRE(n_checked >= 4u);
}

BOOST_AUTO_TEST_CASE(closest_point_is_on_the_profile)
{
  for_all(
    [](const Shape &shape, const Point2 &x, const Projection &p) {
      const Point2 closest = x - p.distance * p.normal;
      const Projection q = shape.project(closest);
      BOOST_TEST_REQUIRE(std::abs(q.distance) < 1e-13);
      BOOST_TEST_REQUIRE(std::abs(q.arc_length - p.arc_length) < 1e-12);
      return true;
    });
}

BOOST_AUTO_TEST_CASE(closest_point_is_the_closest_of_all)
{
  for_all(
    [](const Shape &shape, const Point2 &x, const Projection &p) {
      if (x[0] < 0) // may be close to the mirror image
        return false;
      for (const Segment &segment : shape.segments())
        for (const Point2 &end : {segment.start, segment.end})
          BOOST_TEST_REQUIRE(std::abs(p.distance) < end.distance(x) + 1e-14);
      return true;
    });
}

BOOST_AUTO_TEST_CASE(normal_is_the_gradient_of_the_distance)
{
  constexpr double h = 1e-6;
  for_all(
    [](const Shape &shape, const Point2 &x, const Projection &p) {
      if (!is_smooth(shape, x, p, h))
        return false;
      for (const Tensor1 &step : steps(h))
        require_close(p.normal * step / h,
                      (shape.project(x + step).distance - shape.project(x - step).distance) / (2 * h),
                      1e-8,
                      "the slope of the distance, by differences,");
      return true;
    });
}

BOOST_AUTO_TEST_CASE(curvature_is_the_derivative_of_the_normal)
{
  constexpr double h = 1e-6;
  for_all(
    [](const Shape &shape, const Point2 &x, const Projection &p) {
      if (!is_smooth(shape, x, p, h))
        return false;
      for (const Tensor1 &step : steps(h))
      {
        const Tensor1 slope = (shape.project(x + step).normal - shape.project(x - step).normal) / (2 * h);
        for (unsigned int d = 0; d < 2; ++d)
          require_close(p.curvature * (p.tangent * step / h) * p.tangent[d],
                        slope[d],
                        1e-7,
                        "the slope of the normal, by differences,");
      }
      return true;
    });
}

BOOST_AUTO_TEST_CASE(slip_rate_is_the_derivative_of_the_arc_length)
{
  constexpr double h = 1e-6;
  for_all(
    [](const Shape &shape, const Point2 &x, const Projection &p) {
      if (!is_smooth(shape, x, p, h))
        return false;
      for (const Tensor1 &step : steps(h))
        require_close(p.slip_rate * (p.tangent * step / h),
                      shape.slip(shape.project(x - step).arc_length, shape.project(x + step).arc_length) / (2 * h),
                      1e-7,
                      "the slope of the arc length, by differences,");
      return true;
    });
}

BOOST_AUTO_TEST_CASE(mean_curvature_is_how_the_normal_turns)
{
  // Between two closest_points, whatever joints lie between them: the angle between their normals.
  for_all(
    [](const Shape &shape, const Point2 &x, const Projection &p) {
      const Point2 closest = x - p.distance * p.normal;
      const Projection a = shape.project(closest - .05 * p.tangent), b = shape.project(closest + .05 * p.tangent);
      const double between = shape.slip(a.arc_length, b.arc_length);
      if (!(between > .01 && between < .2))
        return false;
      const double length = shape.length();
      for (const auto &segment : shape.segments())
        if (segment.kind == Segment::Kind::arc && segment.radius == 0)
          for (const double corner : {segment.arc_start,
                                      -segment.arc_start,
                                      2 * length - segment.arc_start,
                                      segment.arc_start - length,
                                      segment.arc_start + length})
            if (std::abs(corner - a.arc_length - between / 2) < .11)
              return true; // a corner turns the normal without length
      const double angle = std::atan2(a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0], a.normal * b.normal);
      const double found = between * mean_curvature(shape, a.arc_length + between / 2, between / 2);
      require_close(found, -angle, 1e-9, "the angle by the mean curvature");
      return true;
    });
}

BOOST_AUTO_TEST_CASE(mean_curvature_has_no_jumps)
{
  for_all(
    [](const Shape &shape, const Point2 &, const Projection &p) {
      constexpr double reach = .1, h = 1e-7;
      const double s = p.arc_length;
      const double change = mean_curvature(shape, s + h, reach) - mean_curvature(shape, s - h, reach);
      const double slope = curvature_change(shape, s, reach);
      BOOST_TEST_REQUIRE(std::abs(change) <= 2 * h / (reach * smallest_radius(shape)) + 1e-13);
      if (slope == curvature_change(shape, s - h, reach) && slope == curvature_change(shape, s + h, reach))
        require_close(change, 2 * h * slope, 1e-13, "the mean curvature over a step"); // round-off of s
      return true;
    });
}

BOOST_AUTO_TEST_CASE(friction_fades_towards_a_sharp_corner)
{
  constexpr double offset = .05, h = 1e-7;
  const Curve edge({Point2(0., 0.), Point2(1., 0.), Point2(1., -3.)}, {0., 0., 0.});
  const double corner = edge.segments()[1].arc_start, reach = .25 * offset * dealii::numbers::PI_2;
  BOOST_TEST(corner_share(edge, corner, offset).value == 0.);
  for (const double side : {-1., 1.})
  {
    BOOST_TEST(corner_share(edge, corner + side * 1.001 * reach, offset).value == 1.);
    BOOST_TEST(corner_share(edge, corner + side * 1.001 * reach, offset).slope == 0.);
    const CornerShare half = corner_share(edge, corner + side * .5 * reach, offset);
    BOOST_TEST(half.value == .5, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(half.slope == side / reach, boost::test_tools::tolerance(1e-12));
  }
  // Over the corner half of the slip on either side is missing.
  BOOST_TEST(offset_slip(edge, corner - 2. * reach, corner + 2. * reach, offset) == 3. * reach,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(offset_slip(edge, corner, corner + h, offset) == .5 * h * h / reach, boost::test_tools::tolerance(1e-6));
  // A dent and a rounded edge are no corners.
  const Curve dent({Point2(0., 0.), Point2(1., 0.), Point2(1., 3.)}, {0., 0., 0.}),
    rounded({Point2(0., 0.), Point2(1., 0.), Point2(1., -3.)}, {0., .1, 0.});
  for (const Curve &curve : {dent, rounded})
    for (double s = 0.; s < curve.length(); s += .01)
      BOOST_TEST_REQUIRE(corner_share(curve, s, offset).value == 1.);
}

BOOST_AUTO_TEST_CASE(slip_of_a_node_kept_off_does_work_with_its_share_of_the_force)
{
  // d(slip)/d(node) = c/(1 + mean k offset) for a node at the distance of the offset, joints or not.
  for_all(
    [](const Shape &shape, const Point2 &x, const Projection &p) {
      constexpr double offset = .04, h = 1e-6;
      const Point2 node = x + (offset - p.distance) * p.normal;
      const Projection here = shape.project(node), a = shape.project(node - h * p.tangent),
                       b = shape.project(node + h * p.tangent);
      if (std::abs(here.distance - offset) > 1e-9 || here.slip_rate == 0. || a.segment != b.segment ||
          std::abs(shape.slip(a.arc_length, b.arc_length)) > 1e-4 ||
          curvature_change(shape, a.arc_length, offset) != curvature_change(shape, b.arc_length, offset) ||
          corner_share(shape, a.arc_length, offset).slope != corner_share(shape, b.arc_length, offset).slope) // a kink
        return false;
      const double slope = offset_slip(shape, a.arc_length, b.arc_length, offset) / (2 * h);
      const double curvature = mean_curvature(shape, here.arc_length, offset);
      const double share = corner_share(shape, here.arc_length, offset).value;
      require_close(slope, share / (1. + offset * curvature), 1e-7, "the slip of a node");
      // In two parts as in one.
      const double start = here.arc_length - .2;
      const double to_a = offset_slip(shape, start, a.arc_length, offset);
      const double to_b = offset_slip(shape, start, b.arc_length, offset);
      require_close(to_b - to_a, 2 * h * slope, 1e-8, "the slip in two parts");
      return true;
    });
}

BOOST_AUTO_TEST_CASE(warm_start_changes_nothing)
{
  for_all(
    [](const Shape &shape, const Point2 &x, const Projection &p) {
      const unsigned int n = static_cast<unsigned int>(shape.segments().size());
      for (unsigned int hint = 0; hint <= n; ++hint)
      {
        const Projection q = shape.project(x, hint);
        require_close(q.distance, p.distance, 1e-15, "the distance from another start");
        BOOST_TEST_REQUIRE(q.segment == p.segment);
        BOOST_TEST_REQUIRE((q.normal - p.normal).norm() == 0.);
        BOOST_TEST_REQUIRE(q.arc_length == p.arc_length);
      }
      return true;
    });
}

BOOST_AUTO_TEST_CASE(no_jump_and_no_gap_at_the_joints)
{
  unsigned int n_checked = 0;
  for_all_shapes([&n_checked](const Shape &shape) {
    for (const Segment &s : shape.segments())
    {
      const double side = s.convex ? 1. : -1.;
      std::vector<std::pair<Point2, Tensor1>> rays; // along the normals at the ends of arcs and corners
      if (s.kind == Segment::Kind::arc)
        rays = {{s.start, side * s.from}, {s.end, side * s.to}};
      for (const auto &[joint, normal] : rays)
        for (const double distance : {1e-9, 1e-3, .1, .37, 3.}) // outside of a corner that is no dent
        {
          if (!s.convex && (s.radius == 0 || distance >= s.radius))
            continue;
          const Point2 x = joint + distance * normal;
          if (another_is_closer(shape, x, distance))
            continue;
          ++n_checked;
          for (int a = -1; a <= 1; ++a)
            for (int b = -1; b <= 1; ++b)
            {
              const double r = a == 0 ? x[0] : std::nextafter(x[0], a * 1e9);
              const double z = b == 0 ? x[1] : std::nextafter(x[1], b * 1e9);
              const auto p = shape.project(Point2(r, z));
              BOOST_TEST_REQUIRE(std::abs(p.distance - distance) < 1e-14);
              BOOST_TEST_REQUIRE((p.normal - normal).norm() < 4e-15 / distance + 1e-13);
            }
        }
    }
  });
  BOOST_TEST_REQUIRE(n_checked > 100);
}

BOOST_AUTO_TEST_SUITE_END()
