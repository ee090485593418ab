// What every registered load has to fulfil, on every blank, whatever it is called; and the resultants of ours.
#include "../blanks/any_blank.h"
#include "../conformance.h"

#include <deltaform/loads/load.h>
#include <deltaform/loads/load_way.h>
#include <deltaform/parameters/section.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  const Entries curved_and_coarse = curved({"Material/Model=linear elastic", "Blank/Elements=3"});
  const Entries on_the_outer_edge = {"load/Value=3*t", "load/Boundary=end", "load/Place=.55"};

  Entries documented(const std::string &kind, const Blank &blank)
  {
    return documented_entries([&](ParameterTree &tree) {
      Section section = tree.root().sub("load");
      LoadRegistry::make(kind, section, blank);
    });
  }

  std::unique_ptr<Load> make_load_of(const std::string &kind, const Blank &blank, const Entries &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root().sub("load");
    return LoadRegistry::make(kind, section, blank);
  }

  std::unique_ptr<Load> make_load(const std::string &kind, const Blank &blank, const Entries &overrides)
  {
    return make_load_of(kind, blank, documented(kind, blank) + overrides);
  }

  void for_all_loads(const Entries &base, const std::function<void(Load &, Blank &)> &body)
  {
    BOOST_TEST_REQUIRE(!LoadRegistry::names().empty());
    for_all_blanks(base,
                   [&](Blank &blank, const Entries &) {
                     for (const auto &kind : LoadRegistry::names())
                     {
                       const auto make = [&](const Entries &entries) {
                         return make_load_of(kind, blank, entries + on_the_outer_edge);
                       };
                       BOOST_TEST_CONTEXT("load '" << kind << "'")
                       with_two_sets(documented(kind, blank), make,
                                     [&](const Entries &entries) { body(*make(entries), blank); });
                     }
                   });
  }

  /// Component by component, to a share of the norm.
  void require_close(const Eigen::VectorXd &forces, const Eigen::VectorXd &expected, const double share,
                     const std::string &what)
  {
    for (Eigen::Index i = 0; i < forces.size(); ++i)
      testing::require_close(forces[i], expected[i], share * expected.norm(), what + " " + std::to_string(i));
  }

  Eigen::VectorXd forces(const Load &load, const Vector &q, const double value)
  {
    DenseTarget target(q.size(), false);
    load.add(q, value, target);
    return -target.residual;
  }

  /// Sum of the forces of a unit load in the undeformed state, along z.
  double resultant(const std::string &kind, Blank &blank, const Entries &overrides = on_the_outer_edge)
  {
    const Eigen::VectorXd force = forces(*make_load(kind, blank, overrides), Vector(blank.n_dofs()), 1.);
    double sum = 0.;
    blank.rigid_motion(Vector(blank.n_dofs()), Tensor1({0., 1.}), 0.,
                       [&](const DofIndex dof, const double value) { sum += value * force[dof]; });
    return sum;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(load_conformance)

BOOST_AUTO_TEST_CASE(forces_are_proportional_to_the_value)
{
  std::mt19937 generator(11);
  for_all_loads(curved_and_coarse,
                [&](Load &load, Blank &blank) {
                  const Vector q = random_state(blank, generator, .02);
                  const Eigen::VectorXd unit = forces(load, q, 1.);
                  BOOST_TEST_REQUIRE(unit.norm() > 0.);
                  BOOST_TEST_REQUIRE(unit.allFinite());
                  BOOST_TEST_REQUIRE(forces(load, q, 0.).norm() == 0.);
                  require_close(forces(load, q, -7.), -7. * unit, 1e-14, "of seven times the load, force");
                  // The value is a function of time.
                  DenseTarget target(q.size(), false);
                  BOOST_TEST_REQUIRE(load.assemble(q, 2., target).good());
                  require_close(-target.residual, 6. * unit, 1e-14, "of a value over time, force");
                });
}

BOOST_AUTO_TEST_CASE(the_tangent_is_the_derivative)
{
  // Beside a unit stiffness, against which the tangent of a dead load is none.
  std::mt19937 generator(12);
  for_all_loads(curved_and_coarse,
                [&](Load &load, Blank &blank) {
                  const Vector q = random_state(blank, generator, .02);
                  const Assembly beside_springs = [&](const Vector &state, AssemblyTarget &target) {
                    load.add(state, 7., target);
                    for (DofIndex i = 0; i < state.size(); ++i)
                    {
                      const double one = 1., force = state[i];
                      target.add(&i, 1, target.wants_tangent() ? &one : nullptr, &force);
                    }
                  };
                  BOOST_TEST_REQUIRE(tangent_error(beside_springs, q, std::vector<double>(q.size(), 1.), 1e-4) < 1e-9);
                });
}

BOOST_AUTO_TEST_CASE(the_way_is_what_the_load_works_on)
{
  // dV = f.dq where nodes go straight, and beside it where the ends of a face turn off; by central differences.
  std::mt19937 generator(13);
  for_all_loads(curved_and_coarse,
                [&](Load &load, Blank &blank) {
                  if (!load.history().empty())
                    return; // what it works on depends on its history
                  const Vector q = random_state(blank, generator, .02), d = random_state(blank, generator, 1.);
                  constexpr double h = 1e-5;
                  Vector before = q, after = q;
                  before.add(-h, d);
                  after.add(h, d);
                  const double slope = (LoadWay(load, after).value() - LoadWay(load, before).value()) / (2. * h);
                  testing::require_close(LoadWay(load, q).gradient() * d, slope, 1e-7 * std::abs(slope) + 1e-12,
                                         "the slope of the way, by differences,");
                  // Along the straight way itself the gradient is the force.
                  Vector along = q;
                  along *= .5;
                  double work = 0.;
                  for (DofIndex i = 0; i < q.size(); ++i)
                    work += forces(load, along, 1.)[i] * q[i];
                  testing::require_close(LoadWay(load, along).gradient() * q, work, 1e-9 * std::abs(work) + 1e-14,
                                         "the work along a straight way");
                });
}

BOOST_AUTO_TEST_CASE(the_tangent_of_a_load_that_follows_its_way)
{
  for_all_blanks(curved_and_coarse,
                 [](Blank &blank, const Entries &) {
                   std::mt19937 generator(14);
                   for (const std::string kind : {"pressure", "edge"})
                   {
                     const auto load =
                       make_load(kind, blank,
                                 {"load/Value=.01*t", "load/Boundary=end",
                                  std::string("load/Control=") + (kind == "edge" ? "displacement" : "volume")});
                     load->set_unknown(blank.n_dofs());
                     const Vector state = random_state(blank, generator, .02);
                     Vector q(blank.n_dofs() + 1);
                     std::copy(state.begin(), state.end(), q.begin());
                     q[blank.n_dofs()] = 3.;
                     const Assembly beside_springs = [&](const Vector &x, AssemblyTarget &target) {
                       BOOST_TEST(load->assemble(x, 2., target).good());
                       for (DofIndex i = 0; i < x.size(); ++i)
                       {
                         const double one = 1., force = x[i];
                         target.add(&i, 1, target.wants_tangent() ? &one : nullptr, &force);
                       }
                     };
                     BOOST_TEST(tangent_error(beside_springs, q, std::vector<double>(q.size(), 1.), 1e-4) < 1e-8);
                   }
                 });
}

BOOST_AUTO_TEST_CASE(volume_under_a_lifted_ring)
{
  for_all_blanks({"Blank/Points=.3 0; 1.1 0", "Blank/Thickness=.01", "Blank/Elements=3"},
                 [](Blank &blank, const Entries &) {
                   const auto load = make_load("pressure", blank, {"load/Value=t"});
                   Vector q(blank.n_dofs());
                   blank.rigid_motion(q, Tensor1({0., .4}), 0.,
                                      [&](const DofIndex dof, const double value) { q[dof] = value; });
                   const double area = blank.axisymmetric() ? dealii::numbers::PI * (1.21 - .09) : .8;
                   BOOST_TEST(std::abs(LoadWay(*load, q).value() - .4 * area) <= 1e-12);
                 });
}

BOOST_AUTO_TEST_CASE(numbering_anew_changes_nothing_on_the_same_mesh)
{
  for_all_loads(curved_and_coarse,
                [&](Load &load, Blank &blank) {
                  const Vector q(blank.n_dofs());
                  const Eigen::VectorXd before = forces(load, q, 1.);
                  load.renumber();
                  require_close(forces(load, q, 1.), before, 0., "numbered anew, force");
                });
}

BOOST_AUTO_TEST_CASE(a_pressed_face_is_one_of_the_blank)
{
  for_all_loads(curved_and_coarse,
                [&](Load &load, Blank &blank) {
                  const auto faces = blank.boundary().faces();
                  const std::string face = load.pressed_face();
                  BOOST_TEST((face.empty() || std::find(faces.begin(), faces.end(), face) != faces.end()), face);
                });
}

BOOST_AUTO_TEST_CASE(resultants)
{
  // A ring or a strip from .3 to 1.1, .01 thick.
  for_all_blanks({"Blank/Points=.3 0; 1.1 0", "Blank/Thickness=.01", "Blank/Elements=3"},
                 [](Blank &blank, const Entries &) {
                   const double pi = dealii::numbers::PI, h = blank.fields().is_sheet() ? 1. : .01;
                   const double area = blank.axisymmetric() ? pi * (1.21 - .09) : .8;
                   const double length = blank.axisymmetric() ? 2. * pi * 1.1 : 1.;
                   const auto close = [](const double a, const double b) { return std::abs(a - b) <= 1e-12 * b; };
                   // The bottom is pressed upwards; an edge of a solid has the height of the blank.
                   BOOST_TEST(close(resultant("pressure", blank), area));
                   BOOST_TEST(close(resultant("dead pressure", blank), area));
                   BOOST_TEST(close(resultant("edge", blank), length * h));
                   BOOST_TEST(close(resultant("body", blank), area * .01));
                 });
}

BOOST_AUTO_TEST_CASE(what_is_no_load_is_refused)
{
  for_all_blanks({"Blank/Points=0 0; 1 0", "Blank/Thickness=.01", "Blank/Elements=3"},
                 [](Blank &blank, const Entries &) {
                   BOOST_CHECK_THROW(make_load("body", blank, {"load/Component=rotation"}), SceneError);
                   if (blank.axisymmetric())
                     BOOST_CHECK_THROW(make_load("edge", blank, {"load/Boundary=start"}), SceneError);
                   if (!blank.fields().is_sheet())
                     BOOST_CHECK_THROW(make_load("edge", blank, {"load/Component=rotation", "load/Boundary=end"}),
                                       SceneError);
                 });
}

BOOST_AUTO_TEST_SUITE_END()
