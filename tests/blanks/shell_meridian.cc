// The meridian of a shell as contact sees it when its points lie inside the elements.
#include "any_blank.h"

#include <Eigen/Dense>

#include <cmath>
#include <random>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double pi = dealii::numbers::PI;

  std::unique_ptr<Blank> strip(const unsigned int n_elements, const unsigned int n_points, const Entries &more = {})
  {
    Entries entries{"Blank/Points=0 0; 1 0",
                    "Blank/Thickness=.01",
                    "Blank/Symmetry=plane strain",
                    "Blank/Elements=" + std::to_string(n_elements),
                    "Blank/Contact points=gauss",
                    "Blank/Gauss points=" + std::to_string(n_points),
                    "Material/Young's modulus=2e3"};
    entries.insert(entries.end(), more.begin(), more.end());
    return make_blank("shell", entries);
  }

  ContactPoint point(const Blank &blank, const Vector &q, const unsigned int i)
  {
    ContactPoint result;
    blank.surface().contact_point(q, Side::top, i, ContactThickness::current, result);
    return result;
  }

  /// A strip from 0 to 1 bent to an arc of the angle @p total with its length kept.
  Vector bent(const Blank &blank, const double total)
  {
    const Vector zero(blank.n_dofs());
    Vector q = zero;
    const auto places = blank.positions(zero);
    for (unsigned int i = 0; i < blank.surface().n_contact_points(Side::top); ++i)
    {
      const ContactPoint carried = point(blank, zero, i);
      for (unsigned int a = 0; a < carried.n_nodes; ++a)
      {
        const double s = places[carried.nodes[a].node][0], R = 1. / total;
        q[carried.dofs[3 * a]] = R * std::sin(s / R) - s;
        q[carried.dofs[3 * a + 1]] = -R * (1. - std::cos(s / R));
        q[carried.dofs[3 * a + 2]] = -s / R;
      }
    }
    return q;
  }

  /// Rows of all points, to the vertical direction, by displacement and rotation: in units of the square root of the
  /// area (multipliers) and of the L2 norm of the face (displacements).
  double inf_sup(const unsigned int n_elements, const unsigned int n_points)
  {
    const auto blank = strip(n_elements, n_points);
    const unsigned int n = blank->surface().n_contact_points(Side::top), n_dofs = blank->n_dofs();
    const auto fine = strip(n_elements, 5);
    const auto rows = [&](const Blank &of) {
      const unsigned int count = of.surface().n_contact_points(Side::top);
      Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, n_dofs);
      for (unsigned int i = 0; i < count; ++i)
      {
        const ContactPoint p = point(of, Vector(n_dofs), i);
        for (unsigned int k = 0; k < p.n_dofs; ++k)
          result(i, p.dofs[k]) += p.jacobian[k][1] * std::sqrt(p.area);
      }
      return result;
    };
    // M = C^T C with five points is the exact mass of the cubic face; only unknowns that move it count.
    const Eigen::MatrixXd C = rows(*blank), F = rows(*fine);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> mass(F.transpose() * F);
    std::vector<unsigned int> moving;
    for (unsigned int k = 0; k < n_dofs; ++k)
      if (mass.eigenvalues()[k] > 1e-12 * mass.eigenvalues()[n_dofs - 1])
        moving.push_back(k);
    Eigen::MatrixXd B(n, moving.size());
    for (unsigned int k = 0; k < moving.size(); ++k)
      B.col(k) = C * mass.eigenvectors().col(moving[k]) / std::sqrt(mass.eigenvalues()[moving[k]]);
    if (n > moving.size())
      return 0.;
    return B.jacobiSvd().singularValues()[n - 1];
  }
} // namespace

BOOST_AUTO_TEST_SUITE(shell_meridian)

BOOST_AUTO_TEST_CASE(an_arc_is_an_arc)
{
  // The sixth order of the angle of an element, where a chord has the second.
  for (const unsigned int degree : {1, 2})
  {
    std::array<double, 2> error{};
    for (const unsigned int k : {0, 1})
    {
      const auto blank = strip(k == 0 ? 4 : 8, 4, {"Blank/Degree=" + std::to_string(degree)});
      const double total = 2.;
      const Vector q = bent(*blank, total);
      Vector residual(blank->n_dofs());
      blank->commit(q);
      double area = 0.;
      for (unsigned int i = 0; i < blank->surface().n_contact_points(Side::top); ++i)
      {
        const ContactPoint p = point(*blank, q, i);
        error[k] = std::max(error[k], std::abs(p.x.distance(Point2(0., -1. / total)) - 1. / total));
        area += p.area;
      }
      BOOST_TEST(std::abs(area - 1.) < 1e-5);
    }
    BOOST_TEST(error[0] < 2e-6);
    BOOST_TEST(error[1] < error[0] / 40.);
  }
}

BOOST_AUTO_TEST_CASE(the_face_follows_an_arc)
{
  // Its direction at a point is that of the arc, also where elements of other lengths meet. At the ends of the sheet
  // there is none.
  const double total = 1.;
  for (const std::string points : {"gauss", "nodes"})
    for (const std::string degree : {"1", "2"})
    {
      std::array<double, 2> error{};
      for (const unsigned int k : {0, 1})
      {
        const auto inside = strip(k == 0 ? 8 : 16, 4, {"Blank/Degree=" + degree, "Blank/Grading=0: 1, 1: 3"});
        const auto blank =
          strip(k == 0 ? 8 : 16, 4, {"Blank/Degree=" + degree, "Blank/Grading=0: 1, 1: 3", "Blank/Contact points=" + points});
        const Vector q = bent(*inside, total);
        blank->commit(q);
        unsigned int without = 0;
        const unsigned int n = blank->surface().n_contact_points(Side::top);
        for (unsigned int i = 0; i < n; ++i)
        {
          const auto face = blank->surface().face_direction(q, Side::top, i, ContactThickness::current);
          if (!face)
          {
            ++without;
            continue;
          }
          const ContactPoint p = point(*blank, q, i);
          const Tensor1 radius = p.x - Point2(0., -1. / total);
          error[k] = std::max(error[k], std::abs(face->along * radius) / radius.norm());
          BOOST_TEST(std::abs(face->along.norm() - 1.) < 1e-14);
          BOOST_TEST(face->along[0] > 0.);
          BOOST_TEST(std::abs(face->offset_rate) < 1e-3);
        }
        BOOST_TEST(without == (points == "nodes" ? 2u : 8u));
      }
      BOOST_TEST(error[0] < 1e-2);
      // A parabola by the lengths of its chords has the tangent of the circle.
      BOOST_TEST(error[1] < (points == "nodes" ? 1e-14 : error[0] / 3.5));
    }
}

BOOST_AUTO_TEST_CASE(no_place_moves_further_than_the_bound)
{
  const auto blank = strip(3, 10);
  const ContactSurface &surface = blank->surface();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1., 1.);
  double closest = 0.;
  for (unsigned int trial = 0; trial < 200; ++trial)
  {
    Vector from(blank->n_dofs()), to(blank->n_dofs());
    const double places = std::pow(10., 2. * any(random) - 1.);
    for (unsigned int i = 0; i < from.size(); ++i)
    {
      from[i] = .3 * any(random);
      to[i] = from[i] + places * any(random);
    }
    for (unsigned int i = 0; i < surface.n_contact_points(Side::top); ++i)
    {
      const ContactPoint a = point(*blank, from, i), b = point(*blank, to, i);
      std::array<double, ContactPoint::max_dofs> change{};
      for (unsigned int k = 0; k < a.n_dofs; ++k)
        change[k] = to[a.dofs[k]] - from[a.dofs[k]];
      const double bound = surface.largest_motion(Side::top, i / 10, change);
      BOOST_TEST(a.x.distance(b.x) <= bound);
      closest = std::max(closest, a.x.distance(b.x) / bound);
    }
  }
  BOOST_TEST(closest > .8);
}

BOOST_AUTO_TEST_CASE(the_ends_of_a_sheet_touch)
{
  // Both ends of a strip; of a disc the rim only: on the axis the face goes on. Inner nodes are no points.
  for (const std::string symmetry : {"plane strain", "axisymmetric"})
  {
    const auto blank = strip(4, 3, {"Blank/Symmetry=" + symmetry});
    const unsigned int n = blank->surface().n_contact_points(Side::bottom);
    BOOST_TEST(n == 12u);
    const Vector q(blank->n_dofs());
    double area = 0.;
    for (unsigned int i = 0; i < n; ++i)
    {
      const ContactPoint p = point(*blank, q, i);
      const bool at_node = std::abs(4. * p.x[0] - std::round(4. * p.x[0])) < 1e-9;
      const bool in_outer_element = i > 8 || (i < 3 && symmetry == "plane strain");
      BOOST_TEST(at_node == (in_outer_element && i % 3 != 1));
      BOOST_TEST(p.area > 0.);
      area += p.area;
    }
    BOOST_TEST(std::abs(point(*blank, q, n - 1).x[0] - 1.) < 1e-14);
    BOOST_TEST(std::abs(area - (symmetry == "axisymmetric" ? pi : 1.)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(areas_of_a_curved_blank)
{
  // A quarter of a hemisphere as meridian: the tangents of the undeformed blank count, not its chords.
  for (const std::string degree : {"1", "2"})
  {
    const auto blank = make_blank(
      "shell", {"Blank/Points=0 1; 1 1; 1 0",
                "Blank/Fillet radii=0, .999999, 0",
                "Blank/Thickness=.01",
                "Blank/Elements=12",
                "Blank/Degree=" + degree,
                "Blank/Contact points=gauss",
                "Material/Young's modulus=2e3"});
    double area = 0.;
    for (unsigned int i = 0; i < blank->surface().n_contact_points(Side::top); ++i)
      area += point(*blank, Vector(blank->n_dofs()), i).area;
    BOOST_TEST(std::abs(area - 2. * pi) < 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(two_points_hold_the_face_and_no_more)
{
  // Two points per element: as many as the face has freedoms, whatever the mesh. Three are redundant.
  BOOST_TEST(inf_sup(5, 2) > .3);
  BOOST_TEST(inf_sup(40, 2) > .3);
  BOOST_TEST(inf_sup(40, 1) > .3);
  BOOST_TEST(inf_sup(40, 3) < 1e-10);
}

BOOST_AUTO_TEST_CASE(points_that_are_left_open_lie_inside_where_something_holds_the_sheet_and_move_where_it_slides)
{
  const auto touched = [](const DeltaSize delta, const bool slides, const Entries &more) {
    Entries entries{"Blank/Points=0 0; 1 0", "Blank/Thickness=.01", "Blank/Elements=4", "Material/Young's modulus=2e3"};
    entries.insert(entries.end(), more.begin(), more.end());
    auto blank = make_blank("shell", entries);
    blank->touch_inside(delta, slides);
    return blank;
  };
  const auto are_inside = [&](const DeltaSize delta, const Entries &more) {
    return touched(delta, false, more)->surface().points_per_edge() > 0u;
  };
  const auto move = [&](const DeltaSize delta, const Entries &more) {
    return touched(delta, true, more)->surface().points_move();
  };
  const std::string strip = "Blank/Symmetry=plane strain";
  for (const DeltaSize delta : {DeltaSize::coarse, DeltaSize::fine})
  {
    BOOST_TEST(are_inside(delta, {}));
    BOOST_TEST(are_inside(delta, {strip}) == (delta == DeltaSize::coarse));
    BOOST_TEST(are_inside(delta, {strip, "Blank/Contact points=gauss"}));
    BOOST_TEST(!move(delta, {}));
    BOOST_TEST(move(delta, {strip}) == (delta == DeltaSize::fine));
    BOOST_TEST(!move(delta, {strip, "Blank/Contact points=gauss"}));
    for (const std::string stays :
         {"Blank/Contact points=nodes", "Blank/Membrane=true", "Blank/Contact point=outer fibre"})
    {
      BOOST_TEST(!are_inside(delta, {stays}), stays);
      BOOST_TEST(!move(delta, {strip, stays}), stays);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_has_no_smooth_meridian_is_refused)
{
  for (const std::string entry : {"Blank/Membrane=true", "Blank/Contact point=outer fibre"})
  {
    std::string message;
    try
    {
      strip(4, 2, {entry});
    }
    catch (const SceneError &error)
    {
      message = error.what();
    }
    BOOST_TEST(message.find("Contact points") != std::string::npos, message);
  }
}

BOOST_AUTO_TEST_SUITE_END()
