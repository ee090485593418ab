// Refining a solid: patch test and tangent with hanging nodes, and what a finer mesh inherits.
#include "any_blank.h"

#include <set>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  Entries distorted(const std::string &degree, const std::string &kinematics, const Entries &material)
  {
    Entries result = {"Blank/Kinematics=" + kinematics,
                      "Blank/Degree=" + degree,
                      "Blank/Points=.5 0; 1 .2; 2 0",
                      "Blank/Thickness=.6",
                      "Blank/Thickness variation=0: 1, .5: .7, 1: 1.3",
                      "Blank/Elements=4",
                      "Blank/Grading=1+t",
                      "Blank/Elements through thickness=2",
                      "Material/Young's modulus=2e3",
                      "Blank/Refinement/Criterion=contact",
                      "Blank/Refinement/Maximal level=4"};
    result.insert(result.end(), material.begin(), material.end());
    return result;
  }

  /// Refine the cell of one edge of the top, @p times times, so that cells of three sizes meet.
  Vector refine_one_edge(Blank &blank, const Vector &q, const unsigned int times = 2)
  {
    std::vector<Vector> fields{q};
    for (unsigned int k = 0; k < times; ++k)
    {
      std::array<std::vector<double>, 2> longest;
      longest[1].assign(blank.surface().contact_edges(Side::top).size(), 1e300);
      longest[1][2] = 0.;
      const unsigned int n_before = blank.adaptive()->n_cells();
      BOOST_TEST_REQUIRE(blank.adaptive()->mark(longest));
      blank.adaptive()->refine(fields);
      BOOST_TEST(blank.adaptive()->n_cells() >= n_before + 3);
    }
    return fields.front();
  }

  /// Which node an unknown moves by itself.
  std::vector<DofRole> own_nodes(const Blank &blank)
  {
    std::vector<DofRole> result(blank.n_dofs());
    const auto start = blank.positions(Vector(blank.n_dofs()));
    for (unsigned int i = 0; i < blank.n_dofs(); ++i)
    {
      Vector q(blank.n_dofs());
      q[i] = 1.;
      const auto moved = blank.positions(q);
      for (unsigned int n = 0; n < moved.size(); ++n)
        for (unsigned int k = 0; k < 2; ++k)
          if (std::abs(moved[n][k] - start[n][k] - 1.) < 1e-12)
            result[i] = {n, k};
    }
    return result;
  }

  /// u = (a + b X) with the nodes' places.
  Vector field(const Blank &blank, const std::function<double(unsigned int, const Point2 &)> &u)
  {
    const auto role = own_nodes(blank);
    const auto X = blank.positions(Vector(blank.n_dofs()));
    Vector q(blank.n_dofs());
    for (unsigned int i = 0; i < q.size(); ++i)
      q[i] = u(role[i].axis, X[role[i].node]);
    return q;
  }

  double stretch(const unsigned int axis, const Point2 &X)
  {
    return (axis == 0 ? .15 : -.2) * X[axis];
  }

  /// Bending and stretching, so that some points yield and others do not.
  double bend(const unsigned int axis, const Point2 &X)
  {
    return axis == 0 ? .015 * X[0] * X[1] : -.0075 * X[0] * X[0];
  }

  double largest_inside(Blank &blank, const Vector &q)
  {
    const auto forces = residual(blank, q);
    std::set<DofIndex> outside;
    for (const auto &name : blank.boundary().parts())
      for (const auto component : {Component::r, Component::z})
        for (const auto dof : blank.boundary().dofs(name, component))
          outside.insert(dof);
    double largest = 0.;
    for (unsigned int i = 0; i < q.size(); ++i)
      if (outside.count(i) == 0)
        largest = std::max(largest, std::abs(forces[i]));
    BOOST_TEST(outside.size() < q.size());
    return largest / forces.lpNorm<Eigen::Infinity>();
  }

  std::vector<double> drawn(const Blank &blank, const Vector &q, const std::string &name)
  {
    for (const auto &values : blank.fields().draw(q, {}).fields)
      if (values.name == name)
        return values.values;
    BOOST_TEST_REQUIRE(false, "no field " + name);
    return {};
  }

  void for_all(const Entries &material, const std::function<void(Blank &, const Entries &)> &body)
  {
    for (const std::string degree : {"1", "2"})
      for (const std::string kinematics : {"finite", "small"})
        for (const std::string symmetry : {"axisymmetric", "plane strain"})
        {
          Entries entries = distorted(degree, kinematics, material);
          entries.push_back("Blank/Symmetry=" + symmetry);
          BOOST_TEST_CONTEXT("degree " << degree << ", " << kinematics << ", " << symmetry)
          body(*make_blank("solid", entries), entries);
        }
  }
} // namespace

BOOST_AUTO_TEST_SUITE(solid_refinement)

BOOST_AUTO_TEST_CASE(patch_test_with_hanging_nodes)
{
  for_all(elastic,
          [](Blank &blank, const Entries &) {
            const unsigned int n_before = blank.n_dofs();
            refine_one_edge(blank, Vector(blank.n_dofs()));
            BOOST_TEST(blank.n_dofs() > n_before);
            BOOST_TEST(blank.positions(Vector(blank.n_dofs())).size() > blank.n_dofs() / 2); // some hang
            BOOST_TEST(largest_inside(blank, field(blank, stretch)) < 1e-13);
            BOOST_TEST(largest_inside(blank, field(blank, bend)) > 1e-3);
          });
}

BOOST_AUTO_TEST_CASE(tangent_with_hanging_nodes)
{
  for_all(
    elastic,
    [](Blank &blank, const Entries &) {
      refine_one_edge(blank, Vector(blank.n_dofs()), 1);
      const Vector q = field(blank, bend);
      const double error = tangent_error(
        [&](const Vector &state, AssemblyTarget &target) { assemble(blank, state, target); }, q, scales(blank), 1e-4);
      BOOST_TEST(error < 1e-8);
    });
}

BOOST_AUTO_TEST_CASE(displacements_come_over_exactly)
{
  for_all(elastic,
          [](Blank &blank, const Entries &) {
            const Vector before = field(blank, bend);
            assemble(blank, before, *std::make_unique<DenseTarget>(before.size(), false));
            blank.commit(before);
            const auto places = blank.positions(before);
            const auto rotation = [](const unsigned int axis, const Point2 &X) {
              return axis == 0 ? -.5 * X[0] - .8 * X[1] : .8 * X[0] - .5 * X[1] + 1.;
            };
            const Vector after = refine_one_edge(blank, before);
            const auto now = blank.positions(after);
            for (const auto &x : places)
            {
              double nearest = 1.;
              for (const auto &y : now)
                nearest = std::min(nearest, x.distance(y));
              BOOST_TEST(nearest < 1e-14);
            }
            // A linear field is what the mesh carries, whatever its curves.
            std::vector<Vector> fields{field(blank, rotation)};
            const std::size_t n_edges = blank.surface().contact_edges(Side::bottom).size();
            BOOST_TEST_REQUIRE(blank.adaptive()->mark({{std::vector<double>(n_edges, 0.), {}}}));
            blank.adaptive()->refine(fields);
            Vector expected = field(blank, rotation);
            expected -= fields.front();
            BOOST_TEST(expected.linfty_norm() < 1e-13);
          });
}

BOOST_AUTO_TEST_CASE(uniform_plastic_state_comes_over_exactly)
{
  for_all(plastic,
          [](Blank &blank, const Entries &) {
            const Vector q = field(blank, stretch);
            assemble(blank, q, *std::make_unique<DenseTarget>(q.size(), false));
            blank.commit(q);
            const double elastic_before = blank.energy().elastic, plastic_before = blank.energy().plastic;
            const double strain = drawn(blank, q, "equivalent_plastic_strain").front();
            const Vector after = refine_one_edge(blank, q);
            BOOST_TEST(blank.energy().elastic == elastic_before, boost::test_tools::tolerance(1e-11));
            BOOST_TEST(blank.energy().plastic == plastic_before);
            for (const double value : drawn(blank, after, "equivalent_plastic_strain"))
              BOOST_TEST(value == strain, boost::test_tools::tolerance(1e-12));
            BOOST_TEST(largest_inside(blank, after) < 1e-11);
            blank.commit(after);
            BOOST_TEST(blank.energy().plastic == plastic_before, boost::test_tools::tolerance(1e-12));
          });
}

BOOST_AUTO_TEST_CASE(plastic_state_stays_admissible)
{
  // Of every cell once, for two first meshes. At unchanged displacements the law then brings every stress to within
  // yield. A child has a projection of the volumetric strain of its own, so that the elastic energy is another one;
  // that and the work of coming back to the yield surface go with the square of the length of the cells.
  for_all(
    plastic,
    [](const Blank &, const Entries &entries) {
      std::vector<std::array<double, 2>> jumps;
      for (const auto &[along, across] : {std::pair("4", "4"), std::pair("8", "8")})
      {
        Entries mine = entries;
        mine.push_back("Blank/Elements=" + std::string(along));
        mine.push_back("Blank/Elements through thickness=" + std::string(across));
        const auto blank = make_blank("solid", mine);
        Vector q = field(*blank, bend);
        for (const double share : {.5, 1.})
        {
          Vector part = q;
          part *= share;
          assemble(*blank, part, *std::make_unique<DenseTarget>(q.size(), false));
          blank->commit(part);
        }
        const BlankEnergy before = blank->energy();
        const auto old = drawn(*blank, q, "equivalent_plastic_strain");
        const double most = *std::max_element(old.begin(), old.end());
        BOOST_TEST(*std::min_element(old.begin(), old.end()) < .2 * most);
        BOOST_TEST(most > 1e-3);

        std::vector<Vector> fields{q};
        std::array<std::vector<double>, 2> longest;
        for (const auto side : {Side::bottom, Side::top})
          longest[static_cast<unsigned int>(side)].assign(blank->surface().contact_edges(side).size(), 0.);
        BOOST_TEST_REQUIRE(blank->adaptive()->mark(longest));
        blank->adaptive()->refine(fields);
        q = fields.front();
        for (const double value : drawn(*blank, q, "equivalent_plastic_strain"))
        {
          BOOST_TEST(value >= 0.);
          BOOST_TEST(value < 2. * most); // a cell shows one or the mean of its points
        }
        const double elastic = blank->energy().elastic;

        assemble(*blank, q, *std::make_unique<DenseTarget>(q.size(), false));
        blank->commit(q);
        const auto strain = drawn(*blank, q, "equivalent_plastic_strain");
        const auto stress = drawn(*blank, q, "stress_von_mises");
        for (unsigned int i = 0; i < stress.size(); ++i)
          BOOST_TEST(stress[i] < (4. + 20. * strain[i]) * (1. + 1e-9));
        jumps.push_back({{std::abs(elastic / before.elastic - 1.), blank->energy().plastic / before.plastic - 1.}});
      }
      BOOST_TEST_MESSAGE("jumps of the elastic energy " << jumps[0][0] << ", " << jumps[1][0]
                                                        << ", plastic work of the transfer " << jumps[0][1] << ", "
                                                        << jumps[1][1]);
      BOOST_TEST(jumps[1][0] < 2e-3);
      BOOST_TEST(jumps[0][1] >= 0.);
      BOOST_TEST(jumps[1][1] < .4 * jumps[0][1]);
      BOOST_TEST(jumps[1][1] < .01);
    });
}

BOOST_AUTO_TEST_CASE(stress_of_distorted_cells_stays)
{
  // x = X/h'(Z), z = h(Z) keeps every volume, but a cell that interpolates it only its own as a whole: between its
  // points the volume differs by many times the yield strain, of which neither parent nor children must know.
  constexpr double stretch = 1.;
  const auto squeeze = [](const unsigned int axis, const Point2 &X, const double part) {
    const double a = part * stretch, h = std::exp(a * X[1]);
    return axis == 0 ? X[0] / h - X[0] : (h - 1.) / a - X[1];
  };
  for (const std::string degree : {"1", "2"})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      Entries entries = distorted(degree, "finite", plastic);
      entries.push_back("Blank/Symmetry=plane strain");
      const auto blank = make_blank("solid", entries);
      constexpr unsigned int n_parts = 20;
      Vector q;
      for (unsigned int k = 1; k <= n_parts; ++k)
      {
        q = field(*blank,
                  [&](const unsigned int axis, const Point2 &X) {
                    return squeeze(axis, X, k / static_cast<double>(n_parts));
                  });
        assemble(*blank, q, *std::make_unique<DenseTarget>(q.size(), false));
        blank->commit(q);
      }
      const BlankEnergy before = blank->energy();
      q = refine_one_edge(*blank, q, 1);
      BOOST_TEST_MESSAGE("elastic energy " << before.elastic << " to " << blank->energy().elastic);
      BOOST_TEST(blank->energy().elastic == before.elastic, boost::test_tools::tolerance(.02));
      for (const double value : drawn(*blank, q, "equivalent_plastic_strain"))
        BOOST_TEST(value > 0.);
      const auto plastic_strain = drawn(*blank, q, "plastic_strain");
      for (unsigned int i = 0; i < plastic_strain.size(); i += 4)
        BOOST_TEST(std::abs(plastic_strain[i] + plastic_strain[i + 1] + plastic_strain[i + 2]) < 1e-12);
      assemble(*blank, q, *std::make_unique<DenseTarget>(q.size(), false));
      blank->commit(q);
      BOOST_TEST(blank->energy().plastic == before.plastic, boost::test_tools::tolerance(.01));
    }
}

BOOST_AUTO_TEST_CASE(new_contact_nodes_know_their_neighbours)
{
  const auto blank = make_blank("solid", distorted("2", "small", elastic));
  const auto old = blank->surface().n_contact_points(Side::top);
  refine_one_edge(*blank, Vector(blank->n_dofs()), 1);
  const auto &origins = blank->adaptive()->point_origins(Side::top);
  BOOST_TEST(origins.size() == old + 2);
  BOOST_TEST(origins.size() == blank->surface().n_contact_points(Side::top));
  unsigned int n_new = 0, next = 0;
  for (const auto &[a, b, share] : origins)
    if (a == b)
      BOOST_TEST(a == next++);
    else
    {
      BOOST_TEST(share == .5);
      ++n_new;
      BOOST_TEST(a == next - 1);
      BOOST_TEST(b == next);
    }
  BOOST_TEST(n_new == 2u);
  BOOST_TEST(next == old);
  BOOST_TEST(blank->adaptive()->point_origins(Side::bottom).size() == blank->surface().n_contact_points(Side::bottom));
}

BOOST_AUTO_TEST_CASE(a_refined_state_is_saved_and_loaded)
{
  for_all(plastic,
          [](Blank &blank, const Entries &entries) {
            Vector q = field(blank, bend);
            assemble(blank, q, *std::make_unique<DenseTarget>(q.size(), false));
            blank.commit(q);
            q = refine_one_edge(blank, q);
            const auto other = make_blank("solid", entries);
            other->set_state(blank.state());
            BOOST_TEST_REQUIRE(other->n_dofs() == blank.n_dofs());
            const auto a = residual(blank, q), b = residual(*other, q);
            BOOST_TEST((a - b).lpNorm<Eigen::Infinity>() == 0.);
            BOOST_TEST(other->energy().elastic == blank.energy().elastic);
          });
}

BOOST_AUTO_TEST_CASE(another_mesh_begins_with_a_formed_body)
{
  // What is the same everywhere comes over exactly to any mesh, and so does the work of the forces on a linear field.
  const auto block = [](const std::string &degree, const std::string &symmetry, const Entries &mesh) {
    Entries entries = {"Blank/Kinematics=finite", "Blank/Symmetry=" + symmetry, "Blank/Degree=" + degree,
                       "Blank/Points=.5 0; 2 0", "Blank/Thickness=.6", "Material/Young's modulus=2e3"};
    entries.insert(entries.end(), mesh.begin(), mesh.end());
    entries.insert(entries.end(), plastic.begin(), plastic.end());
    return make_blank("solid", entries);
  };
  const Entries coarse = {"Blank/Elements=4", "Blank/Elements through thickness=2", "Blank/Grading=1+t"},
                fine = {"Blank/Elements=7", "Blank/Elements through thickness=3"},
                trimmed = {"Blank/Elements=5", "Blank/Elements through thickness=3", "Blank/Points=.5 0; 1.5 0"};
  for (const std::string symmetry : {"axisymmetric", "plane strain"})
    for (const auto &[from, to] : {std::pair("1", "1"), std::pair("2", "1"), std::pair("1", "2")})
      BOOST_TEST_CONTEXT(symmetry << ", degree " << from << " to " << to)
      {
        const auto old = block(from, symmetry, coarse);
        const Vector q = field(*old, stretch);
        assemble(*old, q, *std::make_unique<DenseTarget>(q.size(), false));
        old->commit(q);
        old->begin_increment(0., 0.);
        const KeyedArrays formed = old->formed(q);
        const double strain = drawn(*old, q, "equivalent_plastic_strain").front();
        const auto forces = residual(*old, q);

        const auto other = block(to, symmetry, fine);
        const TakenOver taken = other->take_formed(formed);
        const Vector expected = field(*other, stretch);
        for (unsigned int i = 0; i < expected.size(); ++i)
          BOOST_TEST(std::abs(taken.unknowns[i] - expected[i]) < 1e-13);
        for (const double value : drawn(*other, expected, "equivalent_plastic_strain"))
          BOOST_TEST(value == strain, boost::test_tools::tolerance(1e-11));
        BOOST_TEST(other->energy().elastic == old->energy().elastic, boost::test_tools::tolerance(1e-10));
        BOOST_TEST(largest_inside(*other, expected) < 1e-11);
        BOOST_TEST_REQUIRE(taken.held.has_value());
        double work = 0., old_work = 0.;
        for (unsigned int i = 0; i < expected.size(); ++i)
          work += (*taken.held)[i] * expected[i];
        for (unsigned int i = 0; i < q.size(); ++i)
          old_work += forces[i] * q[i];
        BOOST_TEST(work == old_work, boost::test_tools::tolerance(1e-12));

        const auto part = block(to, symmetry, trimmed);
        BOOST_TEST(largest_inside(*part, part->take_formed(formed).unknowns) < 1e-11);
        const auto longer = block(to, symmetry, {"Blank/Elements=4", "Blank/Points=.5 0; 2.5 0"});
        const auto is_no_part = [](const SceneError &error) {
          return std::string(error.what()).find("no part of the one that was formed") != std::string::npos;
        };
        BOOST_CHECK_EXCEPTION(longer->take_formed(formed), SceneError, is_no_part);
      }
}

BOOST_AUTO_TEST_CASE(the_error_of_a_linear_stress_is_none)
{
  // Pure bending of a beam by its exact displacements: degree 2 has the stress in its space, and so has the recovery.
  Entries entries = {"Blank/Kinematics=small",
                     "Blank/Degree=2",
                     "Blank/Symmetry=plane strain",
                     "Blank/Points=0 0; 4 0",
                     "Blank/Thickness=1",
                     "Blank/Elements=4",
                     "Material/Model=linear elastic",
                     "Material/Young's modulus=1",
                     "Material/Poisson's ratio=0",
                     "Blank/Refinement/Criterion=recovery"};
  const auto pure = [](const unsigned int axis, const Point2 &X) {
    return axis == 0 ? -.01 * X[0] * X[1] : .005 * X[0] * X[0];
  };
  const auto cubic = [](const unsigned int axis, const Point2 &X) { return axis == 0 ? .01 * std::pow(X[0], 3) : 0.; };
  const auto error = [&](const auto &u, const std::string &n) {
    Entries mine = entries;
    mine.push_back("Blank/Elements=" + n);
    const auto blank = make_blank("solid", mine);
    const Vector q = field(*blank, u);
    assemble(*blank, q, *std::make_unique<DenseTarget>(q.size()));
    blank->commit(q);
    blank->adaptive()->mark({});
    return blank->adaptive()->estimated_error();
  };
  BOOST_TEST(error(pure, "4") < 1e-10);
  // A cubic displacement: of second order, and the estimate is the error itself to some per cent. Interpolated by
  // quadratics, u' of x^3 on a cell of length h misses 3/4 h^2 (xi^2 - 1/3) in xi = [-1, 1] up to its mean.
  for (const auto n : {8, 16})
  {
    const double h = 4. / n, exact = h * h * .75 * std::sqrt(4. / 45.) / (3. * std::sqrt(256. / 5.));
    BOOST_TEST_MESSAGE(n << " cells: " << error(cubic, std::to_string(n)) << ", exact " << exact);
    BOOST_TEST(std::abs(error(cubic, std::to_string(n)) / exact - 1.) < .2);
  }
}

BOOST_AUTO_TEST_CASE(the_error_of_an_even_flow_is_none)
{
  const auto flow = [](const auto &u, const std::string &n, const Entries &more = {}) {
    Entries entries = {"Blank/Kinematics=small",
                       "Blank/Symmetry=plane strain",
                       "Blank/Points=0 0; 1 0",
                       "Blank/Thickness=1",
                       "Blank/Elements=" + n,
                       "Blank/Elements through thickness=" + n,
                       "Material/Young's modulus=1e6",
                       "Material/Poisson's ratio=.3",
                       "Material/Hardening/Law=perfectly plastic",
                       "Material/Hardening/Flow stress=1"};
    entries.insert(entries.end(), more.begin(), more.end());
    const auto blank = make_blank("solid", entries);
    const Vector q = field(*blank, u);
    assemble(*blank, q, *std::make_unique<DenseTarget>(q.size()));
    blank->commit(q);
    return blank->fields().mesh_error(q);
  };
  // Pressed by one per cent in plane strain: its work is 2/sqrt(3) of the flow stress.
  const auto even = [](const unsigned int axis, const Point2 &X) { return (axis == 0 ? .01 : -.01) * X[axis]; };
  for (const std::string degree : {"1", "2"})
  {
    const MeshError error = flow(even, "4", {"Blank/Degree=" + degree});
    BOOST_TEST(std::abs(error.work / (.01 * 2. / std::sqrt(3.)) - 1.) < 1e-4);
    BOOST_TEST(error.error < 1e-10 * error.work);
  }
  // A flow that turns from place to place: strains of degree 1 are wrong by the length of a cell, the work by its
  // square.
  const auto turning = [](const unsigned int axis, const Point2 &X) {
    return axis == 0 ? .01 * (X[0] + X[0] * X[0]) : -.01 * X[1] * (1. + 2. * X[0]);
  };
  std::vector<double> shares;
  for (const std::string n : {"8", "16", "32"})
  {
    const MeshError error = flow(turning, n);
    shares.push_back(error.error / error.work);
  }
  BOOST_TEST_MESSAGE("shares of the work: " << shares[0] << ", " << shares[1] << ", " << shares[2]);
  BOOST_TEST(std::abs(shares[0] / shares[1] - 4.) < .4);
  BOOST_TEST(std::abs(shares[1] / shares[2] - 4.) < .2);
  // None is told of a sheet, and without flow.
  BOOST_TEST(flow(turning, "8", {"Blank/Points=0 0; 11 0"}).work == 0.);
  const MeshError elastic = flow(turning, "8", {"Material/Hardening/Flow stress=1e9"});
  BOOST_TEST(elastic.work == 0.);
  BOOST_TEST(elastic.error == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
