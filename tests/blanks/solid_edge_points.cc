// The face of a solid as contact sees it when its points lie inside the edges.
#include "any_blank.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <set>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  std::unique_ptr<Blank> strip(const unsigned int degree, const unsigned int n_elements, const unsigned int n_points,
                               const Entries &more = {})
  {
    Entries entries{"Blank/Points=0 0; 1 0",
                    "Blank/Thickness=.1",
                    "Blank/Symmetry=plane strain",
                    "Blank/Degree=" + std::to_string(degree),
                    "Blank/Elements=" + std::to_string(n_elements),
                    "Blank/Contact points=gauss",
                    "Blank/Gauss points=" + std::to_string(n_points),
                    "Material/Young's modulus=2e3"};
    entries.insert(entries.end(), more.begin(), more.end());
    return make_blank("solid", entries);
  }

  ContactPoint point(const Blank &blank, const Vector &q, const unsigned int i)
  {
    ContactPoint result;
    blank.surface().contact_point(q, Side::top, i, ContactThickness::current, result);
    return result;
  }

  unsigned int count(const Blank &blank)
  {
    return blank.surface().n_contact_points(Side::top);
  }

  /// Rows of all points, to the vertical direction, over the root of their areas, of the unknowns that move the face.
  Eigen::MatrixXd rows(const Blank &blank)
  {
    const Vector zero(blank.n_dofs());
    std::set<DofIndex> concerned;
    for (unsigned int i = 0; i < count(blank); ++i)
    {
      const ContactPoint p = point(blank, zero, i);
      for (unsigned int k = 1; k < p.n_dofs; k += 2)
        concerned.insert(p.dofs[k]);
    }
    const std::vector<DofIndex> order(concerned.begin(), concerned.end());
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count(blank), order.size());
    for (unsigned int i = 0; i < count(blank); ++i)
    {
      const ContactPoint p = point(blank, zero, i);
      for (unsigned int k = 1; k < p.n_dofs; k += 2)
        result(i, std::lower_bound(order.begin(), order.end(), p.dofs[k]) - order.begin()) +=
          p.jacobian[k][1] * std::sqrt(p.area);
    }
    return result;
  }

  /// Singular values of the rows, in L2 norms of face and multipliers, that are not zero.
  std::vector<double> singular_values(const unsigned int degree, const unsigned int n_elements,
                                      const unsigned int n_points)
  {
    const Eigen::MatrixXd C = rows(*strip(degree, n_elements, n_points)), F = rows(*strip(degree, n_elements, 5));
    const Eigen::LLT<Eigen::MatrixXd> mass(F.transpose() * F);
    const Eigen::MatrixXd scaled = mass.matrixL().solve(C.transpose());
    const Eigen::VectorXd all = Eigen::JacobiSVD<Eigen::MatrixXd>(scaled).singularValues();
    std::vector<double> result;
    for (const double value : all)
      if (value > 1e-9)
        result.push_back(value);
    return result;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(solid_edge_points)

BOOST_AUTO_TEST_CASE(points_lie_on_the_edges_and_share_their_area)
{
  std::mt19937 generator(31);
  for (const unsigned int degree : {1u, 2u})
    for (const std::string symmetry : {"plane strain", "axisymmetric"})
      BOOST_TEST_CONTEXT("degree " << degree << ", " << symmetry)
      {
        const auto blank = strip(degree, 4, 3, {"Blank/Symmetry=" + symmetry});
        const Vector zero(blank->n_dofs());
        BOOST_TEST(count(*blank) == 12u);
        BOOST_TEST(blank->surface().points_per_edge() == 3u);
        double area = 0.;
        const Vector q = random_state(*blank, generator, .01);
        for (unsigned int i = 0; i < count(*blank); ++i)
        {
          const ContactPoint undeformed = point(*blank, zero, i), here = point(*blank, q, i);
          area += undeformed.area;
          BOOST_TEST(std::abs(undeformed.x[1] - .05) < 1e-14);
          double shares = 0.;
          for (unsigned int a = 0; a < here.n_nodes; ++a)
            shares += here.nodes[a].share;
          BOOST_TEST(std::abs(shares - 1.) < 1e-14);
          // The place is linear in the displacements.
          Tensor1 moved;
          for (unsigned int k = 0; k < here.n_dofs; ++k)
            moved += q[here.dofs[k]] * here.jacobian[k];
          BOOST_TEST((here.x - undeformed.x - moved).norm() < 1e-15);
        }
        BOOST_TEST(std::abs(area - (symmetry == "axisymmetric" ? dealii::numbers::PI : 1.)) < 1e-13);
      }
}

BOOST_AUTO_TEST_CASE(how_many_points_are_stable)
{
  // By an independent program: one point of a straight edge and two of a parabola leave a wave of the face that they
  // hardly see, one more is one equation too many for every element but one.
  const auto least = [](const unsigned int degree, const unsigned int n_elements, const unsigned int n_points) {
    return singular_values(degree, n_elements, n_points).back();
  };
  const auto close = [](const double a, const double b) { return std::abs(a - b) < 1e-3; };
  BOOST_TEST(close(least(1, 5, 1), .490));
  BOOST_TEST(close(least(1, 40, 1), .068));
  BOOST_TEST(close(least(1, 40, 2), 1.));
  BOOST_TEST(singular_values(1, 40, 2).size() == 41u);
  BOOST_TEST(close(least(2, 5, 1), 1.376));
  BOOST_TEST(close(least(2, 40, 1), 1.369));
  BOOST_TEST(close(least(2, 5, 2), .381));
  BOOST_TEST(close(least(2, 40, 2), .051));
  BOOST_TEST(close(least(2, 40, 3), 1.));
  BOOST_TEST(singular_values(2, 40, 3).size() == 81u);
}

BOOST_AUTO_TEST_CASE(points_that_are_left_open_lie_inside_where_that_is_asked_for)
{
  const auto count_of = [](const unsigned int degree, const Entries &more, const DeltaSize delta = DeltaSize::coarse) {
    Entries entries{"Blank/Points=0 0; 1 0",
                    "Blank/Thickness=.1",
                    "Blank/Degree=" + std::to_string(degree),
                    "Blank/Elements=4",
                    "Material/Young's modulus=2e3"};
    entries.insert(entries.end(), more.begin(), more.end());
    const auto blank = make_blank("solid", entries);
    const unsigned int before = count(*blank);
    BOOST_TEST(blank->may_be_distributed());
    blank->touch_inside(delta, false);
    BOOST_TEST(blank->may_be_distributed() == (blank->surface().points_per_edge() == 0u));
    return std::pair(before, count(*blank));
  };
  for (const unsigned int degree : {1u, 2u})
  {
    const unsigned int n_nodes = 4 * degree + 1;
    BOOST_TEST((count_of(degree, {}) == std::pair(n_nodes, 4u * 20u)));
    BOOST_TEST((count_of(degree, {"Blank/Gauss points=7"}) == std::pair(n_nodes, 4u * 7u)));
    BOOST_TEST((count_of(degree, {"Blank/Refinement/Criterion=contact"}) == std::pair(n_nodes, 4u * 20u)));
    BOOST_TEST((count_of(degree, {}, DeltaSize::fine) == std::pair(n_nodes, n_nodes)));
    for (const std::string stays : {"Blank/Contact points=nodes", "Blank/Kinematics=small"})
      BOOST_TEST((count_of(degree, {stays}) == std::pair(n_nodes, n_nodes)), stays);
  }
}

BOOST_AUTO_TEST_CASE(no_place_of_an_edge_moves_further_than_is_said)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> any(-1., 1.);
  for (const unsigned int degree : {1u, 2u})
  {
    const auto blank = strip(degree, 1, 1);
    ContactPoint first, here;
    const Vector zero(blank->n_dofs());
    blank->surface().contact_point(zero, Side::top, 0, ContactThickness::current, first);
    double nearest = 0.;
    for (unsigned int repetition = 0; repetition < 500; ++repetition)
    {
      std::array<double, ContactPoint::max_dofs> change{};
      Vector q(blank->n_dofs());
      for (unsigned int k = 0; k < first.n_dofs; ++k)
        q[first.dofs[k]] = change[k] = any(generator);
      const double bound = blank->surface().largest_motion(Side::top, 0, change);
      double largest = 0.;
      for (double xi = 0.; xi <= 1.; xi += .05)
      {
        blank->surface().contact_place(zero, Side::top, 0, xi, ContactThickness::current, first);
        blank->surface().contact_place(q, Side::top, 0, xi, ContactThickness::current, here);
        largest = std::max(largest, (here.x - first.x).norm());
      }
      BOOST_TEST(largest <= bound * (1. + 1e-12));
      nearest = std::max(nearest, largest / bound);
      blank->surface().contact_point(zero, Side::top, 0, ContactThickness::current, first);
    }
    BOOST_TEST(nearest > .75);
  }
}

BOOST_AUTO_TEST_CASE(points_of_a_refined_mesh_know_between_which_old_ones_they_lie)
{
  for (const unsigned int degree : {1u, 2u})
    for (const unsigned int n_points : {1u, 2u, 7u})
      BOOST_TEST_CONTEXT("degree " << degree << ", points " << n_points)
      {
        // Edges of different lengths, of which one is halved.
        const auto blank = strip(degree, 4, n_points, {"Blank/Grading=1 + 2*t", "Blank/Refinement/Criterion=contact"});
        const auto arcs = [&]() {
          std::vector<double> result;
          for (unsigned int i = 0; i < count(*blank); ++i)
            result.push_back(point(*blank, Vector(blank->n_dofs()), i).arc_coordinate);
          return result;
        };
        const std::vector<double> old = arcs();
        const auto [first, last] = std::minmax_element(old.begin(), old.end());
        std::array<std::vector<double>, 2> longest;
        longest[1].assign(4, 1e300);
        longest[1][2] = 0.;
        std::vector<Vector> fields{Vector(blank->n_dofs())};
        BOOST_TEST_REQUIRE(blank->adaptive()->mark(longest));
        blank->adaptive()->refine(fields);
        const std::vector<double> now = arcs();
        const auto &origins = blank->adaptive()->point_origins(Side::top);
        BOOST_TEST_REQUIRE(origins.size() == now.size());
        BOOST_TEST(now.size() == old.size() + n_points);
        for (unsigned int i = 0; i < now.size(); ++i)
        {
          const auto [a, b, share] = origins[i];
          const double there = (1. - share) * old[a] + share * old[b];
          BOOST_TEST(std::abs(std::clamp(now[i], *first, *last) - there) < 1e-13);
        }
      }
}

BOOST_AUTO_TEST_SUITE_END()
