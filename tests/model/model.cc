// A model by itself: its tangent, its stages, its state.
#include "../pressed_strip.h"
#include "../solver/mpi.h"
#include "model_fixture.h"

#include <deltaform/parameters/scene_error.h>

#include <boost/test/unit_test.hpp>

#include <random>
#include <sstream>
#include <utility>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  struct Fixture : ModelFixture
  {
    explicit Fixture(const std::vector<std::string> &more = {})
      : ModelFixture(pressed_strip(more))
    {
    }

    const Stage &stage(const unsigned int i = 0) const
    {
      return scene.actors.stages[i];
    }

    /// Begin an increment and assemble at the end of it.
    Vector residual(const double time, const Vector &q)
    {
      next.begin(time, 0.);
      return again(q);
    }

    Vector again(const Vector &q)
    {
      BOOST_TEST_REQUIRE(next.assemble(q, true).good());
      return workspace.system().residual();
    }

    /// Accept whatever @p q is.
    void accept(const double time, const Vector &q)
    {
      residual(time, q);
      model.commit(q, workspace);
    }
  };

  /// Small against the strip: what touches stays in touch.
  Vector random_unknowns(const Model &model, std::mt19937 &generator, const double size)
  {
    std::uniform_real_distribution<double> number(-size, size);
    Vector q(model.committed().size());
    for (auto &value : q)
      value = number(generator);
    for (DofIndex i = 0; i < q.size(); ++i)
      if (model.discretization().numbering().is_fixed[i])
        q[i] = 0.;
    return q;
  }

  std::string bytes(const ModelState &state)
  {
    std::ostringstream stream;
    state.save(stream);
    return stream.str();
  }

  std::string bytes(const Model &model)
  {
    return bytes(model.state());
  }

  /// The state, of the contact points only what touches: the gap of others is a bound that their search has found.
  std::string touching_bytes(const Model &model)
  {
    ModelState state = model.state();
    state.interfaces.clear();
    for (const auto *const interface : model.interfaces())
      for (const auto &point : interface->committed())
        if (point.touching)
          state.interfaces.emplace_back(reinterpret_cast<const char *>(&point), sizeof(point));
    return bytes(state);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(model)

BOOST_AUTO_TEST_CASE(the_tangent_is_the_derivative_of_the_residual)
{
  // All terms together, border unknowns too: body, contact with friction, a load that follows, one that is controlled.
  const std::vector<std::string> loads{"Loads/Names=blow, ring", "Loads/blow/Value=.3*t",
                                       "Loads/ring/Kind=edge", "Loads/ring/Boundary=end",
                                       "Loads/ring/Component=z", "Loads/ring/Value=.01*t",
                                       "Loads/ring/Control=displacement", "Tools/punch/Friction coefficient=.2"};
  for (const std::string driven : {"Motion=.05*t", "Force=.3*t"})
    BOOST_TEST_CONTEXT(driven)
    {
      auto entries = loads;
      entries.push_back("Tools/punch/" + driven);
      entries.emplace_back("Tools/punch/Direction=0 -1");
      Fixture fixture(entries);
      Model &model = fixture.model;
      BOOST_TEST(model.begin_stage(fixture.stage()).empty());
      std::mt19937 generator(31);
      const Vector q = random_unknowns(model, generator, 1e-4);
      const Vector d = random_unknowns(model, generator, 1.);
      fixture.residual(.2, q);
      // Contact turns the force that the last step foresaw; here it is what the assembly has found.
      fixture.next.active_set()->prepare_step(Vector(q.size()));
      fixture.next.active_set()->advance(1.);
      fixture.again(q);
      const System &system = fixture.workspace.system();
      Vector slope(q.size()), largest(q.size());
      system.for_each_entry([&](const DofIndex row, const DofIndex column, const double value) {
        slope[row] += value * d[column];
        largest[row] += std::abs(value * d[column]);
      });
      constexpr double h = 1e-7;
      Vector before = q, after = q;
      before.add(-h, d);
      after.add(h, d);
      const Vector a = fixture.again(before), b = fixture.again(after);
      for (DofIndex i = 0; i < q.size(); ++i)
      {
        const double difference = (b[i] - a[i]) / (2. * h);
        BOOST_REQUIRE_MESSAGE(std::abs(difference - slope[i]) <= 1e-6 * largest[i] + 1e-6,
                              "row " << i << ": the tangent gives " << slope[i] << ", differences " << difference);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_finer_mesh_is_held_where_it_was_and_steps_go_along)
{
  Fixture fixture({"Steps/Stages=press, stay",
                   "Supports/Names=edge, rim",
                   "Supports/rim/Boundary=end",
                   "Supports/rim/Component=r",
                   "Supports/rim/Hold=true",
                   "Supports/rim/Stages=stay",
                   "Tools/punch/Force=.3*t",
                   "Blank/Refinement/Largest bend=1"});
  Model &model = fixture.model;
  BOOST_TEST(model.begin_stage(fixture.stage()).empty());
  std::mt19937 generator(37);
  Vector q = random_unknowns(model, generator, .01);
  fixture.next.begin(1., 0.);
  for (DofIndex i = 0; i < q.size(); ++i)
    if (fixture.next.is_prescribed()[i])
      q[i] = fixture.next.prescribed()[i];
  fixture.accept(1., q);
  BOOST_TEST(model.begin_stage(fixture.stage(1)).empty());
  const DofIndex travel = model.interfaces()[0]->travel_dof();
  std::vector<Vector> steps{random_unknowns(model, generator, 1e-3), random_unknowns(model, generator, 1e-3)};
  const std::vector<double> ways{steps[0][travel], steps[1][travel]};
  const Vector coarse = model.committed();
  BOOST_TEST_REQUIRE(model.mark());
  model.refine(steps);
  fixture.workspace.follow_mesh();
  const Vector &fine = model.committed();
  BOOST_TEST_REQUIRE(fine.size() > coarse.size());
  const DofIndex travel_now = model.interfaces()[0]->travel_dof();
  for (unsigned int i = 0; i < 2; ++i)
  {
    BOOST_TEST_REQUIRE(steps[i].size() == fine.size());
    BOOST_TEST(steps[i][travel_now] == ways[i]);
  }
  fixture.next.begin(model.time(), 0.);
  unsigned int n_held = 0;
  for (DofIndex i = 0; i < fine.size(); ++i)
    if (fixture.next.is_prescribed()[i] && fine[i] != 0.)
    {
      BOOST_TEST(fixture.next.prescribed()[i] == fine[i]);
      ++n_held;
    }
  BOOST_TEST(n_held == 1); // the rim
}

BOOST_AUTO_TEST_CASE(what_was_tried_leaves_no_trace)
{
  Fixture fixture, other;
  std::mt19937 generator(32);
  for (Fixture *const one : {&fixture, &other})
    one->model.begin_stage(one->stage());
  const Vector q = random_unknowns(fixture.model, generator, 1e-4);
  const Vector wrong = random_unknowns(other.model, generator, .01);
  const std::string fresh = touching_bytes(other.model);
  other.residual(.7, wrong);
  other.workspace.begin(0.);
  BOOST_TEST((touching_bytes(other.model) == fresh));
  other.residual(.2, wrong);
  for (Fixture *const one : {&fixture, &other})
    one->accept(.1, q);
  BOOST_TEST((touching_bytes(fixture.model) == touching_bytes(other.model)));
  BOOST_TEST((touching_bytes(fixture.model) != fresh));
}

BOOST_AUTO_TEST_CASE(a_state_is_a_value)
{
  Fixture fixture;
  std::mt19937 generator(33);
  fixture.model.begin_stage(fixture.stage());
  fixture.accept(.1, random_unknowns(fixture.model, generator, 1e-4));
  ModelState first = fixture.model.state();
  const std::string saved = bytes(first);
  fixture.accept(.2, random_unknowns(fixture.model, generator, 1e-4));
  ModelState second = fixture.model.state();
  BOOST_TEST((bytes(first) == saved)); // whatever the model does
  const std::string later = bytes(second);
  BOOST_TEST((later != saved));
  // Copied, swapped, through a stream.
  const ModelState copy = first;
  std::swap(first, second);
  BOOST_TEST((bytes(first) == later));
  BOOST_TEST((bytes(second) == saved));
  BOOST_TEST((bytes(copy) == saved));
  std::istringstream stream(saved);
  ModelState loaded;
  loaded.load(stream);
  BOOST_TEST((bytes(loaded) == saved));
}

BOOST_AUTO_TEST_CASE(two_states_of_one_model_in_turn)
{
  Fixture fixture;
  Model &model = fixture.model;
  std::mt19937 generator(34);
  model.begin_stage(fixture.stage());
  const Vector q = random_unknowns(model, generator, 1e-4), p = random_unknowns(model, generator, 1e-4);
  const ModelState start = model.state();
  fixture.accept(.1, q);
  const ModelState first = model.state();
  fixture.accept(.2, p);
  const std::string end = bytes(model);
  // From the start along another way, then from the first state as before.
  model.set_state(start, fixture.stage());
  BOOST_TEST((bytes(model) == bytes(start)));
  fixture.accept(.15, p);
  BOOST_TEST((bytes(model) != bytes(first)));
  model.set_state(first, fixture.stage());
  fixture.accept(.2, p);
  BOOST_TEST((bytes(model) == end));
}

BOOST_AUTO_TEST_CASE(two_workspaces_of_one_model)
{
  Fixture fixture;
  std::mt19937 generator(36);
  fixture.model.begin_stage(fixture.stage());
  const Vector q = random_unknowns(fixture.model, generator, 1e-4), p = random_unknowns(fixture.model, generator, 1e-4);
  const auto entries = [](const System &system) {
    std::vector<double> result;
    system.for_each_entry([&](DofIndex, DofIndex, const double value) { result.push_back(value); });
    return result;
  };
  const std::string committed = touching_bytes(fixture.model);
  const Vector residual = fixture.residual(.1, q);
  const std::vector<double> tangent = entries(fixture.workspace.system());
  // Another way to another state with what is its own, and again: a model and a workspace remember nothing of it.
  const Model &model = fixture.model;
  Workspace own(model);
  NextState other(model, own);
  other.begin(.2, 0.);
  BOOST_TEST(other.assemble(p, true).good());
  BOOST_TEST((own.system().residual() != residual));
  BOOST_TEST((fixture.workspace.system().residual() == residual));
  BOOST_TEST((entries(fixture.workspace.system()) == tangent));
  BOOST_TEST((touching_bytes(model) == committed));
  other.begin(.1, 0.);
  BOOST_TEST(other.assemble(q, true).good());
  BOOST_TEST((own.system().residual() == residual));
  BOOST_TEST((entries(own.system()) == tangent));
}

BOOST_AUTO_TEST_CASE(a_state_of_another_mesh_is_refused)
{
  Fixture fixture;
  const Fixture finer({"Blank/Elements=20"});
  BOOST_CHECK_THROW(fixture.model.set_state(finer.model.state(), fixture.stage()), SceneError);
}

BOOST_AUTO_TEST_CASE(forces_left_are_those_that_the_accepted_state_reports)
{
  // Far from equilibrium: tool, load, support and what is inside are anything, and what is left of them is the same
  // whether it is asked before or after the state is accepted.
  for (const std::string symmetry : {"axisymmetric", "plane strain"})
    BOOST_TEST_CONTEXT(symmetry)
    {
      Fixture fixture({"Blank/Symmetry=" + symmetry, "Loads/Names=ring",
                       "Loads/ring/Kind=edge", "Loads/ring/Boundary=end",
                       "Loads/ring/Component=z", "Loads/ring/Value=.01*t"});
      Model &model = fixture.model;
      BOOST_TEST(model.begin_stage(fixture.stage()).empty());
      std::mt19937 generator(36);
      const Vector q = random_unknowns(model, generator, 1e-4);
      fixture.accept(1., q);
      const double left = model.balance_error();
      BOOST_TEST(left > 1e-3);
      BOOST_TEST(fixture.next.imbalance() == left, boost::test_tools::tolerance(1e-9));
    }
}

BOOST_AUTO_TEST_CASE(what_ends_with_a_stage_is_released)
{
  // The punch leaves. What it has pressed with goes on as a force, so that nothing jumps.
  const std::vector<std::string> lift{"Steps/Stages=press, lift", "Steps/lift/End time=2", "Tools/punch/Stages=press"};
  Fixture fixture(lift);
  Model &model = fixture.model;
  model.begin_stage(fixture.stage(0));
  std::mt19937 generator(35);
  const Vector q = random_unknowns(model, generator, 1e-4);
  fixture.accept(1., q);
  const double force = model.tool_forces()[0][1];
  BOOST_TEST(force > 0.);
  BOOST_TEST(model.interfaces().size() == 1u);
  model.begin_stage(fixture.stage(1));
  BOOST_TEST(model.interfaces().empty());
  BOOST_TEST(model.time() == 1.);
  const ReleasedForces released = model.state().released;
  BOOST_TEST(released.of_tools[0][1] == force);
  const double on_blank = model.discretization().numbering().resultant(released.on_blank)[1];
  BOOST_TEST(on_blank == -force, boost::test_tools::tolerance(1e-12));
  fixture.accept(1.5, q);
  BOOST_TEST(model.tool_forces()[0][1] == .5 * force, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(unknowns_are_those_of_the_blank_and_of_what_is_driven)
{
  Fixture fixture({"Tools/punch/Force=t", "Tools/punch/Direction=0 -1", "Loads/Names=blow",
                   "Loads/blow/Value=t", "Loads/blow/Control=volume"});
  const Numbering &numbering = fixture.model.discretization().numbering();
  BOOST_TEST(numbering.n_blank == fixture.scene.actors.blank->n_dofs());
  BOOST_TEST(numbering.n_border == 2u);
  BOOST_TEST(numbering.n() == numbering.n_blank + 2u);
  BOOST_TEST(numbering.scale.size() == numbering.n());
  for (const double scale : numbering.scale)
    BOOST_TEST(scale > 0.);
}

BOOST_AUTO_TEST_SUITE_END()
