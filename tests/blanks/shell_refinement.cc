// Halving the elements of a shell and joining the halves: where the new nodes lie, what they know, and the way back.
#include "any_blank.h"

#include <deltaform/blanks/refinement.h>

#include <cmath>
#include <limits>
#include <numeric>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  Entries strip(const std::string &elements, const Entries &more = {})
  {
    Entries result = {"Blank/Symmetry=plane strain",
                      "Blank/Points=0 0; 4 0",
                      "Blank/Thickness=.1",
                      "Blank/Elements=" + elements,
                      "Blank/Layers=5",
                      "Blank/Contact points=gauss",
                      "Material/Young's modulus=2e3"};
    result.insert(result.end(), plastic.begin(), plastic.end());
    result.insert(result.end(), more.begin(), more.end());
    return result;
  }

  /// Unknown @p k (u_r, u_z, rotation) of every node from its undeformed place.
  Vector state(const Blank &blank, const std::function<double(unsigned int k, const Point2 &X)> &value)
  {
    const auto role = roles(blank);
    const auto X = blank.positions(Vector(blank.n_dofs()));
    Vector q(blank.n_dofs());
    for (unsigned int i = 0; i < q.size(); ++i)
      for (unsigned int n = 0; n < X.size(); ++n)
      {
        const std::string node = "node " + std::to_string(n) + " ", name = blank.describe_dof(i);
        if (name.rfind(node, 0) == 0)
          q[i] = value(role[i].node == invalid_index ? 2 : role[i].axis, X[n]);
      }
    return q;
  }

  /// Wound up on a circle about (0, 1/curvature), and stretched.
  Vector wound(const Blank &blank, const double curvature, const double stretch)
  {
    return state(blank, [&](const unsigned int k, const Point2 &X) {
      const double angle = curvature * stretch * X[0], R = 1. / curvature;
      return k == 0 ? R * std::sin(angle) - X[0] : k == 1 ? R * (1. - std::cos(angle))
                                                          : angle;
    });
  }

  void accept(Blank &blank, const Vector &q)
  {
    blank.begin_increment(0., 0.);
    residual(blank, q);
    blank.commit(q);
  }

  /// Longest allowed edges of a side: those of the elements named have to be shorter.
  std::array<std::vector<double>, 2> short_edges(const Blank &blank, const std::vector<unsigned int> &elements)
  {
    std::array<std::vector<double>, 2> longest;
    longest[1].assign(blank.surface().contact_edges(Side::top).size(), std::numeric_limits<double>::infinity());
    for (const unsigned int e : elements)
      longest[1][e] = 0.;
    return longest;
  }

  Vector remeshed(Blank &blank, const Vector &q, const std::array<std::vector<double>, 2> &longest = {})
  {
    std::vector<Vector> fields{q};
    BOOST_TEST_REQUIRE(blank.adaptive()->mark(longest));
    blank.adaptive()->refine(fields);
    BOOST_TEST_REQUIRE(fields.front().size() == blank.n_dofs());
    return fields.front();
  }

  /// All elements, so many times; wound up once, and flat.
  Vector halved(Blank &blank, const unsigned int times)
  {
    Vector q(blank.n_dofs());
    for (unsigned int k = 0; k < times; ++k)
    {
      std::vector<unsigned int> all(blank.surface().contact_edges(Side::top).size());
      std::iota(all.begin(), all.end(), 0U);
      q = remeshed(blank, q, short_edges(blank, all));
    }
    const double n_edges = blank.surface().contact_edges(Side::top).size();
    double length = 0.;
    for (const Point2 &X : blank.positions(q))
      length = std::max(length, X[0]);
    const double curvature = 6. * dealii::numbers::PI / 180. * n_edges / length;
    accept(blank, wound(blank, curvature, 1.));
    accept(blank, q);
    return q;
  }

  std::vector<double> column(const Blank &blank, const Vector &q, const std::string &name)
  {
    const Table profile = blank.fields().profile(q);
    const auto at = std::find(profile.names.begin(), profile.names.end(), name) - profile.names.begin();
    std::vector<double> result;
    for (const auto &row : profile.rows)
      result.push_back(row.at(static_cast<std::size_t>(at)));
    return result;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(shell_refinement)

BOOST_AUTO_TEST_CASE(new_nodes_lie_on_the_undeformed_meridian)
{
  for (const std::string degree : {"1", "2"})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      // A line, a quarter of a circle about (1, 1) of radius 1, a line
      const auto blank = make_blank("shell",
                                    strip("6", {"Blank/Points=0 0; 2 0; 2 3", "Blank/Fillet radii=0, 1, 0",
                                                "Blank/Degree=" + degree}));
      const auto before = blank->positions(Vector(blank->n_dofs()));
      std::vector<unsigned int> all(blank->surface().contact_edges(Side::top).size());
      for (unsigned int e = 0; e < all.size(); ++e)
        all[e] = e;
      const Vector q = remeshed(*blank, Vector(blank->n_dofs()), short_edges(*blank, all));
      BOOST_TEST(q.linfty_norm() < 1e-14);
      const auto X = blank->positions(q);
      BOOST_TEST_REQUIRE(X.size() == 2 * before.size() - 1);
      for (unsigned int i = 0; i < before.size(); ++i)
        BOOST_TEST(X[2 * i].distance(before[i]) < 1e-14);
      for (const Point2 &x : X)
      {
        const Point2 center(1., 1.);
        const double distance = x[0] < 1. ? std::abs(x[1]) : x[1] > 1. ? std::abs(x[0] - 2.)
                                                                       : x.distance(center) - 1.;
        BOOST_TEST(std::abs(distance) < 1e-14);
      }
      // Free of stress: so are the angles of the director.
      BOOST_TEST(residual(*blank, q).norm() < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(new_nodes_have_moved_with_the_curve)
{
  // A strip is wound up on a circle, and further. The step of a new node is that of the curve through its neighbours;
  // half the sum of their steps would miss the bend of the element, 1e-3 here.
  for (const std::string degree : {"1", "2"})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      const auto blank = make_blank("shell", strip("16", {"Blank/Degree=" + degree}));
      const Vector before = wound(*blank, .3, 1.), now = wound(*blank, .4, 1.);
      accept(*blank, now);
      Vector step = now;
      step -= before;
      std::vector<unsigned int> all(blank->surface().contact_edges(Side::top).size());
      std::iota(all.begin(), all.end(), 0U);
      std::vector<Vector> fields{now, step};
      BOOST_TEST_REQUIRE(blank->adaptive()->mark(short_edges(*blank, all)));
      blank->adaptive()->refine(fields);
      Vector expected = wound(*blank, .4, 1.);
      expected -= wound(*blank, .3, 1.);
      expected -= fields[1];
      BOOST_TEST(expected.linfty_norm() < 1e-5);
    }
}

BOOST_AUTO_TEST_CASE(elements_follow_each_other)
{
  for (const std::string degree : {"1", "2"})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      const auto blank = make_blank("shell", strip("8", {"Blank/Degree=" + degree}));
      for (const double h : {.5, .25})
      {
        const ElementChain &chain = blank->chain();
        // Unknowns that know their node: the place of it, and which they are.
        const Vector x = state(*blank, [](const unsigned int k, const Point2 &X) { return X[0] + 100. * k; });
        BOOST_TEST_REQUIRE(chain.ahead.size() == blank->n_dofs());
        BOOST_TEST_REQUIRE(chain.behind.size() == blank->n_dofs());
        for (DofIndex i = 0; i < blank->n_dofs(); ++i)
        {
          const double place = std::fmod(x[i], 100.);
          BOOST_TEST(std::abs(x[chain.ahead[i]] - x[i] - (place + h < 4. + 1e-9 ? h : 0.)) < 1e-9);
          BOOST_TEST(std::abs(x[i] - x[chain.behind[i]] - (place - h > -1e-9 ? h : 0.)) < 1e-9);
        }
        BOOST_TEST_REQUIRE(chain.rotations.size() == 1 + std::lround(4. / h));
        for (std::size_t e = 0; e < chain.rotations.size(); ++e)
          BOOST_TEST(std::abs(x[chain.rotations[e]] - 200. - h * static_cast<double>(e)) < 1e-9);
        std::vector<unsigned int> all(blank->surface().contact_edges(Side::top).size());
        std::iota(all.begin(), all.end(), 0U);
        remeshed(*blank, Vector(blank->n_dofs()), short_edges(*blank, all));
      }
    }
}

BOOST_AUTO_TEST_CASE(stress_and_strain_come_over)
{
  // Four elements of 14 degrees each; the chords of their halves are longer by 1/cos(14/4) than theirs.
  const auto blank = make_blank("shell", strip("4"));
  const double curvature = .25, half = std::cos(.25 * curvature * 1.02);
  const Vector q = wound(*blank, curvature, 1.02);
  accept(*blank, q);
  const char *const kept[] = {"equivalent_plastic_strain", "stress_meridional_bottom", "stress_meridional_top",
                              "stress_hoop_mid"};
  std::vector<double> values;
  for (const char *const name : kept)
    values.push_back(column(*blank, q, name).front());
  const double thickness = column(*blank, q, "thickness").front();
  BOOST_TEST(values.front() > .01);
  const double energy = blank->energy().elastic;

  const Vector finer = remeshed(*blank, q, short_edges(*blank, {0, 1, 2, 3}));
  for (unsigned int k = 0; k < 4; ++k)
    for (const double value : column(*blank, finer, kept[k]))
      BOOST_TEST(value == values[k], boost::test_tools::tolerance(1e-12));
  for (const double value : column(*blank, finer, "thickness"))
    BOOST_TEST(value == thickness * half, boost::test_tools::tolerance(1e-4));
  // So are the stresses of the equations, and what is stored: the increment at rest dissipates nothing.
  const double plastic_before = blank->energy().plastic;
  accept(*blank, finer);
  BOOST_TEST(blank->energy().plastic == plastic_before, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(blank->energy().elastic == energy, boost::test_tools::tolerance(.01));
  for (unsigned int k = 0; k < 4; ++k)
    for (const double value : column(*blank, finer, kept[k]))
      BOOST_TEST(value == values[k], boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(contact_sees_the_same_face)
{
  const auto blank = make_blank("shell", strip("4"));
  const double curvature = .25;
  const Vector q = wound(*blank, curvature, 1.);
  accept(*blank, q);
  const Vector finer = remeshed(*blank, q, short_edges(*blank, {0, 1, 2, 3}));
  const Point2 center(0., 1. / curvature);
  double off = 0.;
  for (unsigned int i = 0; i < blank->surface().n_contact_points(Side::top); ++i)
  {
    ContactPoint point;
    blank->surface().contact_point(finer, Side::top, i, ContactThickness::initial, point);
    off = std::max(off, std::abs(point.x.distance(center) - 1. / curvature));
  }
  BOOST_TEST(off < 1e-6 * .1); // of the thickness
  const auto &origins = blank->adaptive()->point_origins(Side::top);
  BOOST_TEST_REQUIRE(origins.size() == blank->surface().n_contact_points(Side::top));
  const unsigned int n_old = origins.size() / 2;
  for (const auto &[a, b, share] : origins)
    BOOST_TEST((a < n_old && b < n_old && share >= 0. && share <= 1.));
}

BOOST_AUTO_TEST_CASE(elements_that_bend_are_halved_until_none_bends_or_they_are_short)
{
  const auto blank = make_blank("shell", strip("8", {"Blank/Refinement/Largest bend=10",
                                                     "Blank/Refinement/Shortest element=.5"}));
  // All of the bend in the second element: a fifth of a radian.
  Vector q = state(*blank, [&](const unsigned int k, const Point2 &X) {
    const double angle = X[0] < .75 ? 0. : .2, height = X[0] < .75 ? 0. : .05 + .2 * (X[0] - 1.);
    return k == 2 ? angle : k == 1 ? height
                                   : 0.;
  });
  accept(*blank, q);
  BOOST_TEST(blank->adaptive()->settings().edge_share == 1.5 * 10. * dealii::numbers::PI / 180.);
  // It, and the three on either side that are as long.
  q = remeshed(*blank, q);
  BOOST_TEST(blank->adaptive()->n_cells() == 13u);
  const auto places = column(*blank, q, "R0");
  BOOST_TEST(places[10] == 2.5);
  BOOST_TEST(places[11] == 3.);
  // The last halves would be a quarter as long as the next element: that is halved, too, and what is beyond is not.
  q = remeshed(*blank, q, short_edges(*blank, {9}));
  const auto finer = column(*blank, q, "R0");
  const auto at = [&](const double place) { return std::find(finer.begin(), finer.end(), place) != finer.end(); };
  BOOST_TEST(at(2.375));
  BOOST_TEST(at(1.625));
  BOOST_TEST(!at(1.375));
  BOOST_TEST(at(2.75));
  BOOST_TEST(at(3.25));
  BOOST_TEST(at(3.75));
  // .5 of the thickness is .05, an eighth of .5 is .0625, and half of that is less.
  for (unsigned int k = 0; k < 20; ++k)
  {
    std::vector<unsigned int> all(blank->adaptive()->n_cells());
    for (unsigned int e = 0; e < all.size(); ++e)
      all[e] = e;
    std::vector<Vector> fields{q};
    if (!blank->adaptive()->mark(short_edges(*blank, all)))
      break;
    blank->adaptive()->refine(fields);
    q = fields.front();
  }
  BOOST_TEST(blank->adaptive()->n_cells() == 64u);
}

BOOST_AUTO_TEST_CASE(a_flat_element_at_a_radius_is_halved_if_it_could_not_follow)
{
  const auto longest = [](const double length) {
    std::array<std::vector<double>, 2> result;
    result[0] = {length, 10., 10., 10.};
    return result;
  };
  const auto blank = make_blank("shell", strip("4"));
  accept(*blank, Vector(blank->n_dofs()));
  BOOST_TEST(!blank->adaptive()->mark(longest(.6)));
  BOOST_TEST(blank->adaptive()->mark(longest(.4)));
  // One that begins to bend, away from the tool and towards it
  accept(*blank, wound(*blank, .08, 1.)); // 4.6 degrees an element
  BOOST_TEST(!blank->adaptive()->mark(longest(.6)));
  accept(*blank, wound(*blank, -.08, 1.));
  BOOST_TEST(blank->adaptive()->mark(longest(.6)));
  BOOST_TEST(!blank->adaptive()->mark(longest(1.1)));
}

BOOST_AUTO_TEST_CASE(a_long_element_beside_short_ones_that_bend_is_halved_before_it_does)
{
  // Eight halves, and eight that are twice as long; the last but two of the halves bends.
  const auto blank = make_blank("shell", strip("12"));
  remeshed(*blank, Vector(blank->n_dofs()), short_edges(*blank, {0}));
  BOOST_TEST_REQUIRE(blank->adaptive()->n_cells() == 16u);
  const auto bent = [&](const double angle) {
    return state(*blank, [&](const unsigned int k, const Point2 &X) {
      return k == 2 && X[0] > 5.9 / 6. ? angle : 0.;
    });
  };
  const double degree = dealii::numbers::PI / 180.;
  accept(*blank, bent(5.4 * degree));
  BOOST_TEST(!blank->adaptive()->mark({}));
  accept(*blank, bent(5.6 * degree));
  const Vector finer = remeshed(*blank, bent(5.6 * degree));
  // The first of the long ones is the third from it; three more go with it.
  const auto places = column(*blank, finer, "R0");
  BOOST_TEST(places[9] == 1.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(blank->adaptive()->n_cells() == 20u);
}

BOOST_AUTO_TEST_CASE(where_the_sheet_hardly_yields_elements_are_shorter)
{
  // Yields at a curvature of 2 * 2/(2e3 * .1) = .02; at twice that the square root of a half.
  const double degree = dealii::numbers::PI / 180.;
  const Entries stiff = {"Blank/Points=0 0; 40 0", "Material/Hardening/Initial flow stress=2"};
  const auto is_halved = [&](const double curvature, const double bend) {
    const long n = std::lround(40. * curvature / (bend * degree));
    const auto blank = make_blank("shell", strip(std::to_string(n), stiff));
    const double own = n * bend * degree / 40.;
    accept(*blank, wound(*blank, own, 1.));
    return blank->adaptive()->mark({});
  };
  BOOST_TEST(!is_halved(.04, 10.3));
  BOOST_TEST(is_halved(.04, 10.9));
  BOOST_TEST(!is_halved(.0195, 14.5));
  BOOST_TEST(is_halved(.0195, 15.5));
  BOOST_TEST(!is_halved(.0205, 4.6)); // a third at least
  BOOST_TEST(is_halved(.0205, 4.9));
}

BOOST_AUTO_TEST_CASE(what_found_no_equilibrium_is_left_alone)
{
  const auto blank = make_blank("shell", strip("4"));
  const auto bent = [&](const double angle) {
    return state(*blank, [&](const unsigned int k, const Point2 &X) { return k == 2 && X[0] > 1.5 ? angle : 0.; });
  };
  const Vector q = bent(.3);
  accept(*blank, q);
  const KeyedArrays before = blank->state();
  Adaptive &mesh = *blank->adaptive();
  remeshed(*blank, q);
  BOOST_TEST(mesh.n_cells() == 8u);
  BOOST_TEST_REQUIRE(mesh.goes_back());
  blank->set_state(before);
  BOOST_TEST(mesh.n_cells() == 4u);
  BOOST_TEST((blank->state() == before));
  mesh.leave_marked();
  accept(*blank, q);
  BOOST_TEST(!mesh.mark({}));
  BOOST_TEST(!mesh.mark(short_edges(*blank, {1})));
  // Saved, and so in another run
  const auto other = make_blank("shell", strip("4"));
  other->set_state(blank->state());
  for (Blank *const one : {blank.get(), other.get()})
  {
    accept(*one, bent(.37));
    BOOST_TEST(!one->adaptive()->mark({}));
    accept(*one, bent(.38)); // 1.25 times as much
    BOOST_TEST(one->adaptive()->mark({}));
  }
}

BOOST_AUTO_TEST_CASE(halves_are_joined_where_the_sheet_is_straight)
{
  for (const std::string degree : {"1", "2"})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      const auto blank = make_blank("shell", strip("4", {"Blank/Degree=" + degree}));
      Vector q = halved(*blank, 3);
      BOOST_TEST_REQUIRE(blank->adaptive()->n_cells() == 32u);
      for (const unsigned int n : {16U, 8U})
      {
        q = remeshed(*blank, q);
        BOOST_TEST_REQUIRE(blank->adaptive()->n_cells() == n);
        const auto places = column(*blank, q, "R0");
        for (std::size_t i = 0; i < places.size(); ++i)
          BOOST_TEST(std::abs(places[i] - 4. * static_cast<double>(i) / static_cast<double>(places.size() - 1)) < 1e-14);
      }
      // Four pairs are few.
      BOOST_TEST(!blank->adaptive()->mark({}));
    }
}

BOOST_AUTO_TEST_CASE(halves_that_have_not_been_bent_stay)
{
  const auto blank = make_blank("shell", strip("4"));
  Vector q(blank->n_dofs());
  for (const unsigned int n : {4U, 8U, 16U, 32U})
  {
    std::vector<unsigned int> all(n);
    std::iota(all.begin(), all.end(), 0U);
    q = remeshed(*blank, q, short_edges(*blank, all));
  }
  accept(*blank, q);
  BOOST_TEST(!blank->adaptive()->mark({}));
  // Bent by less, and more, than .3 of 15 degrees
  const double degree = dealii::numbers::PI / 180. * 64. / 4.;
  accept(*blank, wound(*blank, 4.2 * degree, 1.));
  accept(*blank, q);
  BOOST_TEST(!blank->adaptive()->mark({}));
  accept(*blank, wound(*blank, 4.6 * degree, 1.));
  accept(*blank, q);
  const auto other = make_blank("shell", strip("4"));
  other->set_state(blank->state());
  accept(*other, q);
  for (Blank *const one : {blank.get(), other.get()})
    BOOST_TEST(one->adaptive()->mark({}));
}

BOOST_AUTO_TEST_CASE(halves_stay_if_the_scene_says_so)
{
  const auto blank = make_blank("shell", strip("4", {"Blank/Refinement/Join halves=false"}));
  halved(*blank, 3);
  BOOST_TEST(!blank->adaptive()->mark({}));
}

BOOST_AUTO_TEST_CASE(halves_near_what_bends_or_is_needed_by_a_tool_stay)
{
  // Long ones, and a stiff sheet that yields at once: the angle alone decides.
  constexpr double h = 1.;
  const double degree = dealii::numbers::PI / 180.;
  const auto joined = [&](const double bend, const std::vector<unsigned int> &touching) {
    const auto blank = make_blank("shell", strip("4", {"Blank/Points=0 0; 64 0", "Material/Young's modulus=2e5"}));
    halved(*blank, 4);
    Vector q = state(*blank, [&](const unsigned int k, const Point2 &X) { return k == 2 && X[0] > 20.5 * h ? bend : 0.; });
    accept(*blank, q);
    std::array<std::vector<double>, 2> longest;
    longest[0].assign(64, std::numeric_limits<double>::infinity());
    for (const unsigned int e : touching)
      longest[0][e] = 3.9 * h; // twice the length is more than half of it
    q = remeshed(*blank, q, longest);
    const auto places = column(*blank, q, "R0");
    std::vector<unsigned int> result; // of the old elements, the first of those that are joined
    for (std::size_t i = 1; i < places.size(); ++i)
      if (places[i] - places[i - 1] > 1.5 * h)
        result.push_back(static_cast<unsigned int>(std::lround(places[i - 1] / h)));
    return result;
  };
  const auto without = [](const unsigned int begin, const unsigned int end) {
    std::vector<unsigned int> result;
    for (unsigned int c = 0; c < 64; c += 2)
      if (c < begin || c >= end)
        result.push_back(c);
    return result;
  };
  // Bent by 2.9 degrees itself: joined. By 3.1: not, nor its other half. By 4.6: nor the six on either side.
  BOOST_TEST(joined(2.9 * degree, {}) == without(0, 0), boost::test_tools::per_element());
  BOOST_TEST(joined(3.1 * degree, {}) == without(20, 22), boost::test_tools::per_element());
  BOOST_TEST(joined(4.6 * degree, {}) == without(14, 28), boost::test_tools::per_element());
  BOOST_TEST(joined(0., {20}) == without(14, 28), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_neck_stays)
{
  // Stretched by a twentieth, and three elements by 2.5 percent more
  constexpr double h = 4. / 64.;
  const auto blank = make_blank("shell", strip("4"));
  halved(*blank, 4);
  Vector q = state(*blank, [&](const unsigned int k, const Point2 &X) {
    return k == 0 ? .05 * X[0] + .025 * std::clamp(X[0] - 20. * h, 0., 3. * h) : 0.;
  });
  accept(*blank, q);
  const double thinnest = blank->fields().smallest_thickness();
  q = remeshed(*blank, q);
  // 22 is another metal than 23; 20 and 21 are alike.
  BOOST_TEST(blank->adaptive()->n_cells() == 33u);
  BOOST_TEST(blank->fields().smallest_thickness() == thinnest, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(what_the_halves_knew_is_known_to_the_joined)
{
  // Elements of 1.4 degrees that were halved are joined as they had been: thicker again by the square of their angle.
  for (const std::string degree : {"1", "2"})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      const auto blank = make_blank("shell", strip("40", {"Blank/Degree=" + degree}));
      const Vector q = wound(*blank, .25, 1.02);
      accept(*blank, wound(*blank, 2., 1.02)); // 11.5 degrees
      accept(*blank, q);
      const char *const kept[] = {"equivalent_plastic_strain", "stress_meridional_bottom", "stress_meridional_top",
                                  "stress_hoop_mid", "thickness"};
      std::vector<double> values;
      for (const char *const name : kept)
        values.push_back(column(*blank, q, name).front());
      const double energy = blank->energy().elastic;
      std::vector<unsigned int> all(blank->surface().contact_edges(Side::top).size());
      std::iota(all.begin(), all.end(), 0U);
      Vector other = remeshed(*blank, q, short_edges(*blank, all));
      BOOST_TEST_REQUIRE(blank->adaptive()->n_cells() == 80u);
      other = remeshed(*blank, other);
      BOOST_TEST_REQUIRE(blank->adaptive()->n_cells() == 40u);
      other -= q;
      BOOST_TEST(other.linfty_norm() < 1e-12);
      for (std::size_t k = 0; k < values.size(); ++k)
        for (const double value : column(*blank, q, kept[k]))
          BOOST_TEST(value == values[k], boost::test_tools::tolerance(k < 4 ? 1e-9 : 1e-4));
      const double plastic_before = blank->energy().plastic;
      accept(*blank, q);
      BOOST_TEST(blank->energy().plastic == plastic_before, boost::test_tools::tolerance(1e-9));
      BOOST_TEST(blank->energy().elastic == energy, boost::test_tools::tolerance(1e-3));
    }
}

BOOST_AUTO_TEST_CASE(contact_of_the_joined_is_that_of_the_halves)
{
  for (const Entries &points : {Entries{"Blank/Contact points=nodes"}, Entries{"Blank/Contact points=gauss"},
                                Entries{"Blank/Contact points=gauss", "Blank/Degree=2"}})
    BOOST_TEST_CONTEXT(points.back())
    {
      const auto blank = make_blank("shell", strip("4", points));
      Vector q = halved(*blank, 3);
      const auto places = [&] {
        std::vector<double> result;
        for (unsigned int i = 0; i < blank->surface().n_contact_points(Side::top); ++i)
        {
          ContactPoint point;
          blank->surface().contact_point(q, Side::top, i, ContactThickness::initial, point);
          result.push_back(point.x[0]);
        }
        return result;
      };
      const std::vector<double> before = places();
      q = remeshed(*blank, q);
      const std::vector<double> now = places();
      const auto &origins = blank->adaptive()->point_origins(Side::top);
      BOOST_TEST_REQUIRE(origins.size() == now.size());
      for (std::size_t i = 0; i < now.size(); ++i)
      {
        const auto &[first, second, share] = origins[i];
        BOOST_TEST_REQUIRE((first < before.size() && second < before.size()));
        BOOST_TEST(std::abs(before[first] + share * (before[second] - before[first]) - now[i]) < 1e-12);
        BOOST_TEST((share >= 0. && share <= 1.));
      }
    }
}

BOOST_AUTO_TEST_CASE(halves_whose_joining_found_no_equilibrium_stay)
{
  const auto blank = make_blank("shell", strip("4"));
  const Vector q = halved(*blank, 3);
  const KeyedArrays before = blank->state();
  remeshed(*blank, q);
  blank->set_state(before);
  BOOST_TEST_REQUIRE(blank->adaptive()->n_cells() == 32u);
  blank->adaptive()->leave_marked();
  BOOST_TEST(!blank->adaptive()->mark({}));
  // Saved, and so in another run
  const auto other = make_blank("shell", strip("4"));
  other->set_state(blank->state());
  BOOST_TEST(!other->adaptive()->mark({}));
}

BOOST_AUTO_TEST_CASE(a_refined_state_is_saved_and_loaded)
{
  const auto blank = make_blank("shell", strip("4")), other = make_blank("shell", strip("4"));
  Vector q = wound(*blank, .25, 1.02);
  accept(*blank, q);
  const KeyedArrays coarse = blank->state();
  q = remeshed(*blank, q, short_edges(*blank, {1, 2}));
  accept(*blank, q);
  q = remeshed(*blank, q, short_edges(*blank, {2}));
  accept(*blank, q);
  const KeyedArrays fine = blank->state();
  other->set_state(fine);
  BOOST_TEST((other->state() == fine));
  BOOST_TEST(other->adaptive()->n_cells() == blank->adaptive()->n_cells());
  BOOST_TEST((residual(*other, q) - residual(*blank, q)).norm() == 0.);
  other->set_state(coarse);
  BOOST_TEST((other->state() == coarse));
  BOOST_TEST(other->adaptive()->n_cells() == 4u);
}

BOOST_AUTO_TEST_CASE(a_damaged_mesh_is_refused)
{
  const auto blank = make_blank("shell", strip("2"));
  const auto is_told = [](const SceneError &error) {
    return std::string(error.what()).find("no whole mesh: it is damaged") != std::string::npos;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> wrong[] = {{},
                                       {0, 0, 1},
                                       {0, 0, 1, 1, 0},
                                       {0, 0, 1, 2, 0, 1},
                                       {0, 0, .5, 1, 0, 1},
                                       {0, 0, .5, 0, .25, 1, 1, 0, 1},
                                       {0, 0, 1, 1, 0, 2},
                                       {0, 0, nan, 1, 0, 1},
                                       {nan, 0, 1, 1, 0, 1},
                                       {0, 0, 1, 1, 0, 1, 2, 0, 1},
                                       {0, 0, 0, 0, 0, 1, 1, 0, 1}};
  for (const auto &numbers : wrong)
  {
    KeyedArrays state = blank->state();
    state.put("elements of the first mesh", numbers);
    BOOST_CHECK_EXCEPTION(blank->set_state(state), SceneError, is_told);
  }
  BOOST_TEST(blank->adaptive()->n_cells() == 2u);
}

BOOST_AUTO_TEST_CASE(a_later_operation_goes_on_with_the_mesh)
{
  const auto blank = make_blank("shell", strip("4"));
  Vector q = wound(*blank, .25, 1.02);
  accept(*blank, q);
  q = remeshed(*blank, q, short_edges(*blank, {1, 2}));
  accept(*blank, q);
  const KeyedArrays formed = blank->formed(q);

  const auto same = make_blank("shell", strip("4", {"Blank/Contact points=nodes"}));
  const Vector taken = same->take_formed(formed).unknowns;
  BOOST_TEST_REQUIRE(taken.size() == q.size());
  BOOST_TEST((residual(*same, taken) - residual(*blank, q)).norm() < 1e-12 * residual(*blank, q).norm());

  // One that keeps its mesh, and one that begins with another, take what lies there.
  for (const auto &[elements, largest] : {std::pair("4", "0"), {"10", "15"}})
  {
    const auto other = make_blank("shell",
                                  strip(elements, {std::string("Blank/Refinement/Largest bend=") + largest}));
    const unsigned int n_dofs = other->n_dofs();
    const Vector own = other->take_formed(formed).unknowns;
    BOOST_TEST(own.size() == n_dofs);
    for (const Point2 &x : other->positions(own))
      BOOST_TEST(std::abs(x.distance(Point2(0., 4.)) - 4.) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(some_shells_keep_their_mesh)
{
  const auto large = make_blank("shell", strip("20001", {"Blank/Layers=2", "Blank/Refinement/Shortest element=1e-9"}));
  BOOST_TEST(!large->adaptive()->mark(short_edges(*large, {1, 2, 3})));
  BOOST_TEST(make_blank("shell", strip("4"))->adaptive() != nullptr);
  BOOST_TEST(!make_blank("shell", strip("4"))->adaptive()->settings().asked_for);
  BOOST_TEST(make_blank("shell", strip("4", {"Blank/Refinement/Largest bend=0"}))->adaptive() == nullptr);
  BOOST_TEST(make_blank("shell", strip("4", {"Blank/Membrane=true", "Blank/Contact points=nodes"}))->adaptive() ==
             nullptr);
}

BOOST_AUTO_TEST_SUITE_END()
