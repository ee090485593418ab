// What every registered blank has to fulfil at one state, in every variant: forces, tangents, rigid motions, contact
// nodes.
#include "any_blank.h"

#include <sstream>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  const Entries hill = plastic + Entries{"Material/Yield surface/Law=hill", "Material/Yield surface/r-bar=.5"};
  const Entries hosford = plastic + Entries{"Material/Yield surface/Law=hosford",
                                            "Material/Yield surface/r-bar=1.7",
                                            "Material/Yield surface/Exponent=6"};
  const Entries hill_chaboche =
    hill + Entries{"Material/Backstress/Law=chaboche", "Material/Backstress/Terms=200 20; 30 0"};

  Assembly with_pressure(Blank &blank, const double pressure, const bool following)
  {
    return [&blank, pressure, following](const Vector &q, AssemblyTarget &target) {
      assemble(blank, q, target);
      blank.boundary().assemble_pressure(q, blank.boundary().faces().front(), pressure, following, target);
    };
  }

  /// The same pressure of contact on all nodes of the top, and another one on the bottom.
  void press(Blank &blank, const double top, const double bottom)
  {
    const unsigned int n_nodes = blank.surface().n_nodes();
    blank.set_pressure({{std::vector<double>(n_nodes, bottom), std::vector<double>(n_nodes, top)}});
  }
} // namespace

BOOST_AUTO_TEST_SUITE(blank_conformance)

BOOST_AUTO_TEST_CASE(no_forces_without_displacements)
{
  for (const auto &material : {elastic, plastic})
    for_all_blanks(curved(material),
                   [](Blank &blank, const Entries &) {
                     DenseTarget target(blank.n_dofs());
                     assemble(blank, Vector(blank.n_dofs()), target);
                     BOOST_TEST(target.residual.lpNorm<Eigen::Infinity>() <= 1e-14 * blank.stiffness_scale());
                   });
}

BOOST_AUTO_TEST_CASE(elastic_tangent)
{
  std::mt19937 generator(1);
  for_all_blanks(curved(elastic),
                 [&](Blank &blank, const Entries &) {
                   for (const double size : {1e-3, .02})
                   {
                     const Vector q = random_state(blank, generator, size);
                     BOOST_TEST(tangent_error(internal_forces(blank), q, scales(blank), 1e-4 * fineness(blank)) < 1e-8);
                     DenseTarget target(blank.n_dofs());
                     assemble(blank, q, target);
                     BOOST_TEST((target.matrix - target.matrix.transpose()).norm() <= 1e-13 * target.matrix.norm());
                   }
                 });
}

BOOST_AUTO_TEST_CASE(plastic_tangent)
{
  std::mt19937 generator(2);
  for_all_blanks(curved(plastic),
                 [&](Blank &blank, const Entries &) {
                   const Vector q = random_state(blank, generator, .02);
                   BOOST_TEST(tangent_error(internal_forces(blank), q, scales(blank), 1e-6 * fineness(blank)) < 1e-6);
                   press(blank, 1.5, .5);
                   BOOST_TEST(tangent_error(internal_forces(blank), q, scales(blank), 1e-6 * fineness(blank)) < 1e-6);
                 });
}

BOOST_AUTO_TEST_CASE(tangent_after_a_plastic_increment)
{
  std::mt19937 generator(3);
  for_all_blanks(curved(plastic),
                 [&](Blank &blank, const Entries &) {
                   const Vector first = random_state(blank, generator, .02);
                   residual(blank, first);
                   blank.commit(first);
                   BOOST_TEST(blank.energy().plastic > 0.);
                   // Some points go on yielding, others unload, and the thickness is no longer the initial one. The
                   // steps of the differences are so short that no point passes its yield limit within one.
                   for (const double size : {5e-4, 5e-3})
                   {
                     Vector q = first;
                     q += random_state(blank, generator, size);
                     BOOST_TEST(tangent_error(internal_forces(blank), q, scales(blank), 2e-8 * fineness(blank)) < 1e-5);
                   }
                 });
}

// The steps of the differences are so short that no point passes its yield limit within one.
BOOST_AUTO_TEST_CASE(tangent_of_metals_with_axes)
{
  std::mt19937 generator(8);
  for (const auto &metal : {hill_chaboche, hosford})
    for_all_blanks(curved(metal),
                   [&](Blank &blank, const Entries &) {
                     const Vector first = random_state(blank, generator, .02);
                     BOOST_TEST(tangent_error(internal_forces(blank), first, scales(blank), 2e-8 * fineness(blank)) <
                                1e-5);
                     residual(blank, first);
                     blank.commit(first);
                     Vector q = first;
                     q += random_state(blank, generator, 5e-3);
                     BOOST_TEST(tangent_error(internal_forces(blank), q, scales(blank), 2e-8 * fineness(blank)) < 1e-5);
                   });
}

BOOST_AUTO_TEST_CASE(tangent_of_the_pressure)
{
  std::mt19937 generator(4);
  for_all_blanks(
    curved(elastic),
    [&](Blank &blank, const Entries &) {
      const Vector q = random_state(blank, generator, .02);
      for (const bool following : {true, false})
      {
        BOOST_TEST(tangent_error(with_pressure(blank, 7., following), q, scales(blank), 1e-4 * fineness(blank)) < 1e-8);
        const Assembly alone = [&](const Vector &state, AssemblyTarget &target) {
          blank.boundary().assemble_pressure(state, blank.boundary().faces().front(), 7., following, target);
        };
        if (following)
          BOOST_TEST(tangent_error(alone, q, std::vector<double>(q.size(), 1.), 1e-4) < 1e-9);
      }
      // Both kinds are the same where nothing has moved.
      const unsigned int n = blank.n_dofs();
      DenseTarget following(n), dead(n);
      blank.boundary().assemble_pressure(Vector(n), blank.boundary().faces().front(), 7., true, following);
      blank.boundary().assemble_pressure(Vector(n), blank.boundary().faces().front(), 7., false, dead);
      BOOST_TEST((following.residual - dead.residual).norm() == 0.);
      BOOST_TEST(dead.matrix.norm() == 0.);
    });
}

BOOST_AUTO_TEST_CASE(pressure_on_a_flat_blank)
{
  for_all_blanks({"Blank/Points=.3 0; 1.1 0", "Blank/Thickness=.01", "Blank/Elements=3"},
                 [](Blank &blank, const Entries &) {
                   DenseTarget target(blank.n_dofs());
                   const Boundary &boundary = blank.boundary();
                   boundary.assemble_pressure(Vector(blank.n_dofs()), boundary.faces().front(), 7., true, target);
                   const auto role = roles(blank);
                   double total = 0.;
                   for (unsigned int i = 0; i < role.size(); ++i)
                     if (role[i].node != invalid_index && role[i].axis == 1)
                       total -= target.residual[i]; // upwards, as a force
                   const double area = blank.axisymmetric() ? dealii::numbers::PI * (1.1 * 1.1 - .3 * .3) : .8;
                   BOOST_TEST(std::abs(total - 7. * area) < 1e-12 * area);
                 });
}

BOOST_AUTO_TEST_CASE(rigid_motions_are_free)
{
  for (const auto &material : {elastic, plastic})
    for_all_blanks(curved(material),
                   [](Blank &blank, const Entries &) {
                     const Vector zero(blank.n_dofs());
                     const double noise = 1e-12 * blank.stiffness_scale();
                     const auto forces = [&](const double angle, const Tensor1 &shift) {
                       return residual(blank, moved_rigidly(blank, zero, angle, shift)).lpNorm<Eigen::Infinity>();
                     };
                     BOOST_TEST(forces(0., Tensor1({0., 3.7})) <= noise);
                     if (!blank.axisymmetric())
                       for (const double angle : {1e-3, .4, 1.7, -3.1, 6.5})
                         BOOST_TEST(forces(angle, Tensor1({-.7, 1.9})) <= noise);
                   });
}

BOOST_AUTO_TEST_CASE(forces_turn_with_the_blank)
{
  std::mt19937 generator(5);
  for (const auto &metal : {plastic, hill_chaboche})
    for_all_blanks(curved(metal),
                   [&](Blank &blank, const Entries &) {
                     const Vector q = random_state(blank, generator, .02);
                     const auto role = roles(blank);
                     const auto still = residual(blank, q);
                     const double angle = blank.axisymmetric() ? 0. : 2.1, c = std::cos(angle), s = std::sin(angle);
                     const auto turned = residual(blank, moved_rigidly(blank, q, angle, Tensor1({0., -.9})));

                     std::vector<Tensor1> before(blank.positions(q).size()), after(before);
                     for (unsigned int i = 0; i < role.size(); ++i)
                       if (role[i].node == invalid_index)
                         BOOST_TEST(std::abs(turned[i] - still[i]) <= 1e-12 * blank.stiffness_scale());
                       else
                       {
                         before[role[i].node][role[i].axis] = still[i];
                         after[role[i].node][role[i].axis] = turned[i];
                       }
                     for (unsigned int n = 0; n < before.size(); ++n)
                     {
                       const Tensor1 expected(
                         {c * before[n][0] - s * before[n][1], s * before[n][0] + c * before[n][1]});
                       BOOST_TEST((after[n] - expected).norm() <= 1e-11 * blank.stiffness_scale());
                     }
                   });
}

BOOST_AUTO_TEST_CASE(bdf2_predictor_turns_with_the_blank)
{
  // The same plastic history once at rest and once on a turntable: two-step flow knows the axes of its last increment.
  std::mt19937 generator(7);
  for (const auto &metal : {plastic, hill, hill_chaboche})
    for_all_blanks(curved(metal),
                   [&](Blank &blank, const Entries &) {
                     if (blank.axisymmetric())
                       return;
                     const KeyedArrays fresh = blank.state();
                     const Vector direction = random_state(blank, generator, .01);
                     const auto history = [&](const double turn) {
                       std::vector<double> norms;
                       double time = 0., last = 1.;
                       for (const double length : {1., 1., 1.5, .8})
                       {
                         time += length;
                         Vector q = direction;
                         q *= 1. + .2 * time;
                         const Vector turned = moved_rigidly(blank, q, turn * time, Tensor1());
                         blank.begin_increment(length, length / last);
                         last = length;
                         norms.push_back(residual(blank, turned).norm());
                         blank.commit(turned);
                       }
                       norms.push_back(blank.energy().plastic);
                       return norms;
                     };
                     const auto still = history(0.);
                     blank.set_state(fresh);
                     const auto turning = history(.15);
                     for (unsigned int i = 0; i < still.size(); ++i)
                       BOOST_TEST(std::abs(turning[i] / still[i] - 1.) < 1e-9);
                   });
}

BOOST_AUTO_TEST_CASE(derivatives_of_contact_points)
{
  std::mt19937 generator(6);
  for_all_blanks(curved(plastic), [&](Blank &blank, const Entries &) {
    const Vector q = random_state(blank, generator, .02);
    residual(blank, q);
    blank.commit(q);
    for (const Side side : {Side::bottom, Side::top})
      for (const auto thickness : {ContactThickness::current, ContactThickness::initial, ContactThickness::none})
        for (unsigned int i = 0; i < blank.surface().n_contact_points(side); ++i)
        {
          const auto at = [&](const Vector &state) {
            ContactPoint node;
            blank.surface().contact_point(state, side, i, thickness, node);
            return node;
          };
          const ContactPoint node = at(q);
          if (node.n_nodes == 1)
            BOOST_TEST((blank.positions(q)[node.nodes[0].node] - node.x).norm() <= node.thickness);
          double shares = 0.;
          for (unsigned int a = 0; a < node.n_nodes; ++a)
            shares += node.nodes[a].share;
          BOOST_TEST(std::abs(shares - 1.) < 1e-14);
          BOOST_TEST(node.n_dofs <= ContactPoint::max_dofs);
          BOOST_TEST(node.offset >= 0.);
          BOOST_TEST(node.thickness > 0.);
          BOOST_TEST(node.area >= 0.);
          ContactPoint located;
          blank.surface().locate_point(q, side, i, thickness, located);
          BOOST_TEST(located.x.distance(node.x) == 0.);
          BOOST_TEST(located.area == node.area);
          BOOST_TEST(located.offset == node.offset);
          BOOST_TEST(located.thickness == node.thickness);
          BOOST_TEST(located.compliance == node.compliance);
          BOOST_TEST(located.recovery == node.recovery);
          constexpr double h = 1e-4;
          for (unsigned int j = 0; j < q.size(); ++j)
          {
            Vector plus = q, minus = q;
            plus[j] += h;
            minus[j] -= h;
            const ContactPoint a = at(minus), b = at(plus);
            Tensor1 first, second;
            for (unsigned int k = 0; k < node.n_dofs; ++k)
              if (node.dofs[k] == j)
              {
                first = node.jacobian[k];
                second = node.second[k];
              }
            BOOST_TEST(((b.x - a.x) / (2. * h) - first).norm() < 1e-9);
            BOOST_TEST((((b.x - node.x) - (node.x - a.x)) / (h * h) - second).norm() < 1e-6);
            BOOST_TEST(a.offset == b.offset);
          }
        }
  });
}

BOOST_AUTO_TEST_CASE(faces_lie_half_a_thickness_off)
{
  // Whichever point a blank offers, offset and shift along the director together are half a thickness.
  for_all_blanks({"Blank/Points=.3 .1; 1.1 .1", "Blank/Thickness=.01", "Blank/Elements=3"},
                 [](Blank &blank, const Entries &) {
                   const Vector zero(blank.n_dofs());
                   double area = 0.;
                   for (const Side side : {Side::bottom, Side::top})
                     for (unsigned int i = 0; i < blank.surface().n_contact_points(side); ++i)
                     {
                       ContactPoint node;
                       blank.surface().contact_point(zero, side, i, ContactThickness::current, node);
                       const double up = side == Side::top ? 1. : -1.;
                       BOOST_TEST(std::abs(node.x[1] + up * node.offset - .1 - up * .005) < 1e-15);
                       area += node.area;
                     }
                   const double exact = blank.axisymmetric() ? dealii::numbers::PI * (1.1 * 1.1 - .3 * .3) : .8;
                   BOOST_TEST(std::abs(area - 2. * exact) < 1e-12);
                   for (const Side side : {Side::bottom, Side::top})
                     for (const auto &edge : blank.surface().contact_edges(side))
                       for (const unsigned int end : {0, 1})
                         BOOST_TEST(edge[end] < (blank.surface().points_per_edge() > 0
                                                   ? blank.surface().n_nodes()
                                                   : blank.surface().n_contact_points(side)));
                 });
}

BOOST_AUTO_TEST_CASE(boundaries_and_couplings)
{
  for_all_blanks(curved(elastic),
                 [](Blank &blank, const Entries &) {
                   const unsigned int n = blank.n_dofs();
                   for (const auto &boundary : blank.boundary().parts())
                     for (const auto component : {Component::r, Component::z, Component::rotation})
                       for (const auto dof : blank.boundary().dofs(boundary, component))
                         BOOST_TEST((dof < n && !blank.describe_dof(dof).empty()));
                   BOOST_CHECK_THROW(blank.boundary().dofs("nowhere", Component::z), std::invalid_argument);

                   // Every entry of the tangent is in the pattern.
                   dealii::DynamicSparsityPattern pattern(n, n);
                   blank.add_couplings(pattern);
                   std::mt19937 generator(7);
                   DenseTarget target(n);
                   assemble(blank, random_state(blank, generator, .02), target);
                   for (unsigned int i = 0; i < n; ++i)
                     for (unsigned int j = 0; j < n; ++j)
                       BOOST_TEST((target.matrix(i, j) == 0. || pattern.exists(i, j)));
                 });
}

BOOST_AUTO_TEST_SUITE_END()
