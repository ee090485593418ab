// The state of contact points from increment to increment: rollback, promise, corrections, energies, results.
#include "fake_surface.h"

#include <deltaform/contact/contact_measures.h>
#include <deltaform/contact/deepest_place.h>

#include <deltaform/parameters/registry.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double stiffness = 1e3;

  bool same(const ContactPointState &a, const ContactPointState &b)
  {
    return a.touching == b.touching && a.sticking == b.sticking && a.gap == b.gap && a.force == b.force &&
           a.penalty_factor == b.penalty_factor && a.stiffness == b.stiffness && a.arc_length == b.arc_length &&
           a.tangential_force == b.tangential_force && a.tangential_factor == b.tangential_factor && a.slip == b.slip;
  }

  /// Nodes side by side above a plate whose face is at z = 0.
  FakeSurface row(const unsigned int n)
  {
    FakeSurface surface(n);
    for (unsigned int i = 0; i < n; ++i)
      surface.X[i] = Point2(.2 * i, 0.);
    return surface;
  }

  /// All nodes at a height, moved sideways.
  Vector place(const InterfaceFixture &fixture, const double x, const double z)
  {
    Vector q(fixture.n);
    for (unsigned int i = 0; i < fixture.contact.n_points(); ++i)
    {
      q[2 * i] = x;
      q[2 * i + 1] = z;
    }
    return q;
  }

  /// An accepted increment from @p q to @p next, with the elastic slip as small as it may be.
  void go(InterfaceFixture &fixture, Vector &q, const Vector &next, const double time)
  {
    fixture.begin_increment(q, time, stiffness);
    fixture.converge(next);
    for (unsigned int round = 0; round < 9 && fixture.contact.correct_factors(q) > 0; ++round)
      fixture.converge(next);
    fixture.contact.commit(q = next);
  }

  const Entries constant{"Enforcement=penalty", "Penalty rule=constant", "Penalty factor=50", "Continuation=false"};
} // namespace

BOOST_AUTO_TEST_SUITE(contact_state)

BOOST_AUTO_TEST_CASE(an_increment_that_is_given_up_leaves_nothing)
{
  const FakeSurface surface = row(3);
  InterfaceFixture fixture(surface, {"Enforcement=penalty"}, flat + Entries{"Friction coefficient=.2"});
  fixture.contact.begin_stage(place(fixture, 0., .1), 0.);
  fixture.begin_increment(place(fixture, 0., .1), 1., stiffness);
  const Vector q = place(fixture, .01, -.01);
  fixture.converge(q);
  fixture.contact.commit(q);
  const auto committed = fixture.contact.committed();
  const auto energy = fixture.contact.energy();
  BOOST_TEST(fixture.contact.n_touching() == 3u);

  fixture.begin_increment(q, 2., stiffness);
  fixture.converge(place(fixture, .3, -.5));
  fixture.contact.correct_factors(q);
  fixture.converge(place(fixture, .3, .5));
  for (unsigned int i = 0; i < 3; ++i)
    BOOST_TEST(same(fixture.contact.committed()[i], committed[i]));
  fixture.contact.begin_increment(q, 1.5);
  for (unsigned int i = 0; i < 3; ++i)
    BOOST_TEST(same(fixture.contact.trial()[i], committed[i]));
  BOOST_TEST(fixture.contact.energy().epsilon == energy.epsilon);
  BOOST_TEST(fixture.contact.energy().friction == energy.friction);
}

BOOST_AUTO_TEST_CASE(a_step_tells_who_will_touch)
{
  const FakeSurface surface = row(4);
  InterfaceFixture fixture(surface, constant, flat);
  fixture.contact.begin_stage(place(fixture, 0., .1), 0.);
  fixture.begin_increment(place(fixture, 0., .1), 1., stiffness);
  Vector q = place(fixture, 0., -.01);
  q[5] = .002; // free, and near
  q[7] = 3.; // free, and so far away that it is not looked at
  fixture.assemble(q); // from here on the distance of the last one is known
  const auto before = fixture.assemble(q);
  const auto touches = [&](const unsigned int i) { return fixture.contact.trial()[i].touching; };
  BOOST_TEST((touches(0) && touches(1) && !touches(2) && !touches(3)));

  Vector d(fixture.n);
  d[1] = .009;
  d[5] = -.001;
  BOOST_TEST(!fixture.contact.foresee(q, d));
  d[3] = .011; // lets go
  d[5] = -.003; // meets
  BOOST_TEST(fixture.contact.foresee(q, d));
  // What was not near has to be looked at first.
  fixture.assemble(q);
  BOOST_TEST(!touches(2));
  BOOST_TEST(fixture.contact.foresee(q, d));
  // Assembled at the same place: the force of what lets go is gone, what meets is tied to the tool by its spring.
  const auto foreseen = fixture.assemble(q);
  BOOST_TEST((touches(0) && !touches(1) && touches(2) && !touches(3)));
  BOOST_TEST(foreseen.residual[1] == before.residual[1]);
  BOOST_TEST(std::abs(before.residual[3] + 50. * .01) < 1e-12);
  BOOST_TEST(foreseen.residual[3] == 0.);
  BOOST_TEST(std::abs(foreseen.residual[5] - 50. * .002) < 1e-12);
  BOOST_TEST(!fixture.contact.foresee(q, d));
  // What was far away is free until it has been looked at.
  d[7] = -3.001;
  BOOST_TEST(fixture.contact.foresee(q, d));
  fixture.assemble(q);
  BOOST_TEST(!touches(3));
  BOOST_TEST(fixture.contact.foresee(q, d));
  fixture.assemble(q);
  BOOST_TEST(touches(3));
  // The step is taken: from here on the forces decide, as ever.
  fixture.contact.prepare_step(d);
  fixture.contact.advance(1.);
  q = place(fixture, 0., .1);
  fixture.assemble(q);
  for (unsigned int i = 0; i < 4; ++i)
    BOOST_TEST(!touches(i));
}

BOOST_AUTO_TEST_CASE(what_happened_before_does_not_matter)
{
  // Warm starts and the skipping of distant nodes change no force: random walks against fresh interfaces.
  const Entries hemisphere{"Shape=hemispherical punch", "Radius=1", "Side=top", "Position z=0", "Motion=t"};
  FakeSurface surface(4, 0., .05);
  for (unsigned int i = 0; i < 4; ++i)
    surface.X[i] = Point2(.1 + .25 * i, 0.);
  InterfaceFixture walker(surface, constant, hemisphere);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Vector q(walker.n);
  walker.contact.begin_stage(q, 0.);
  walker.begin_increment(q, .3, stiffness);
  unsigned int touching = 0;
  for (unsigned int k = 0; k < 500; ++k)
  {
    for (auto &value : q)
      value = .9 * value + (k % 20 == 0 ? .5 : .03) * uniform(generator);
    InterfaceFixture fresh(surface, constant, hemisphere);
    fresh.contact.begin_stage(q, 0.);
    fresh.begin_increment(q, .3, stiffness);
    const auto a = walker.assemble(q), b = fresh.assemble(q);
    BOOST_TEST((a.residual - b.residual).norm() <= 1e-12);
    touching += fresh.contact.n_touching();
  }
  BOOST_TEST((touching > 100u && touching < 1900u));
}

BOOST_AUTO_TEST_CASE(the_promise)
{
  const FakeSurface surface = row(3);
  InterfaceFixture fixture(
    surface,
    {"Enforcement=penalty", "Penalty rule=adaptive", "Allowed penetration=1e-3", "Aim=.8", "Largest change=10"},
    flat);
  const double delta = 1e-3;
  Vector q = place(fixture, 0., 0.);
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  const auto push = [&](const double p0, const double p1, const double p2) {
    q[1] = -p0;
    q[3] = -p1;
    q[5] = -p2;
    fixture.converge(q);
  };
  push(.5 * delta, 2. * delta, 100. * delta);
  std::vector<double> before;
  for (const auto &state : fixture.contact.trial())
    before.push_back(state.penalty_factor);
  BOOST_TEST(FactorControl::broken_promise(fixture.contact.trial()).first == 2u);
  BOOST_TEST(fixture.contact.correct_factors(q) == 2u);
  BOOST_TEST(fixture.contact.trial()[0].penalty_factor == before[0]);
  BOOST_TEST(std::abs(fixture.contact.trial()[1].penalty_factor / before[1] - 2.5) < 1e-12); // p / (.8 delta)
  BOOST_TEST(std::abs(fixture.contact.trial()[2].penalty_factor / before[2] - 10.) < 1e-12);

  // At delta and a trace above: kept. Clearly above: broken.
  push(delta, delta * (1. + .9e-6), .3 * delta);
  BOOST_TEST(FactorControl::broken_promise(fixture.contact.trial()).first == invalid_index);
  BOOST_TEST(fixture.contact.correct_factors(q) == 0u);
  push(delta * (1. + 1.1e-6), .1 * delta, -delta);
  BOOST_TEST(FactorControl::broken_promise(fixture.contact.trial()).first == 0u);
  BOOST_TEST(fixture.contact.correct_factors(q) == 1u);
}

BOOST_AUTO_TEST_CASE(early_corrections_are_those_after_convergence)
{
  // Points at half of delta, and at two and a hundred times; all creep a hundred times too far.
  const auto factors = [](const std::string &law, const std::string &rule, const bool early, const double softening) {
    const FakeSurface surface = row(3);
    InterfaceFixture fixture(surface,
                             {"Enforcement=" + law, "Penalty rule=" + rule, "Allowed penetration=1e-3",
                              "Allowed elastic slip=1e-6"},
                             flat + Entries{"Friction coefficient=.5"});
    const Vector start = place(fixture, 0., 0.);
    fixture.contact.begin_stage(start, 0.);
    fixture.begin_increment(start, 1., stiffness);
    fixture.contact.soften(softening);
    Vector q = place(fixture, 1e-4, 0.);
    q[1] = -.5e-3;
    q[3] = -2e-3;
    q[5] = -.1;
    fixture.converge(q);
    std::vector<double> result;
    result.push_back(early ? fixture.contact.correct_factors_early() : fixture.contact.correct_factors(q));
    for (const auto &state : fixture.contact.trial())
      result.insert(result.end(), {state.penalty_factor, state.tangential_factor});
    return result;
  };
  // The floors .01 K_nn and .001 K_tt; p / (.8 delta) and at most ten times.
  const std::vector<double> floors = {0., 10., 1., 10., 1., 10., 1.}, corrected = {3., 10., 10., 25., 10., 100., 10.};
  BOOST_TEST(factors("penalty", "adaptive", true, 1.) == corrected, boost::test_tools::per_element());
  BOOST_TEST(factors("penalty", "adaptive", false, 1.) == corrected, boost::test_tools::per_element());
  // A penetration under a share of the force says nothing, nor does one that augmentation will take away.
  BOOST_TEST(factors("penalty", "adaptive", true, .5) == floors, boost::test_tools::per_element());
  BOOST_TEST(factors("augmented Lagrangian", "adaptive", true, 1.) == floors, boost::test_tools::per_element());
  // A rule that promises nothing has its say after convergence only; friction has promised the elastic slip.
  const auto first = factors("penalty", "proportional", true, 1.);
  const auto later = factors("penalty", "proportional", false, 1.);
  BOOST_TEST((first[1] == first[5] && first[5] < later[5]));
  BOOST_TEST(first[6] == later[6]);
}

BOOST_AUTO_TEST_CASE(free_travel_is_the_gap_of_the_closest_node)
{
  // The node on the axis has no area and no contact: it says nothing of how far the tool is away.
  FakeSurface surface = row(3);
  surface.axis_node = 0;
  InterfaceFixture fixture(surface, {"Enforcement=penalty", "Allowed penetration=1e-3"}, flat);
  Vector q = place(fixture, 0., .1);
  q[5] = .07;
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(q);
  BOOST_TEST(std::abs(fixture.contact.free_travel() - .0705) < 1e-14);
  q[5] = -1e-4;
  fixture.converge(q);
  BOOST_TEST(fixture.contact.free_travel() == 0.);
}

BOOST_AUTO_TEST_CASE(round_off_breaks_no_promise)
{
  // delta = 1e-14 at coordinates of size 1: what the coordinates cannot resolve is not counted.
  const FakeSurface surface = row(1);
  InterfaceFixture fixture(surface, {"Enforcement=penalty", "Allowed penetration=1e-14"}, flat);
  Vector q = place(fixture, 1., 0.);
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(place(fixture, 1., -1.1e-14));
  BOOST_TEST(FactorControl::broken_promise(fixture.contact.trial()).first == invalid_index);
  fixture.converge(place(fixture, 1., -1.4e-14));
  BOOST_TEST(FactorControl::broken_promise(fixture.contact.trial()).first == 0u);
}

BOOST_AUTO_TEST_CASE(the_next_factor_comes_from_the_reaction)
{
  const FakeSurface surface = row(2);
  InterfaceFixture fixture(surface, {"Enforcement=penalty", "Penalty rule=adaptive", "Allowed penetration=1e-3"}, flat);
  Vector q = place(fixture, 0., 0.);
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  q = place(fixture, 0., -5e-4);
  fixture.converge(q);
  BOOST_TEST(std::abs(fixture.contact.trial()[0].penalty_factor - .01 * stiffness) < 1e-12); // the floor
  fixture.contact.commit(q);
  BOOST_TEST(fixture.contact.governed_by_floor(0));
  const double force = fixture.contact.committed()[0].force;
  fixture.begin_increment(q, 2., 10.); // a softer blank: the floor is far below
  // From nothing to this force in the last increment: in one as long it is expected to grow as much again.
  BOOST_TEST(std::abs(fixture.contact.trial()[0].penalty_factor - 2 * force / .8e-3) < 1e-12);
  fixture.converge(q);
  fixture.contact.commit(q);
  BOOST_TEST(!fixture.contact.governed_by_floor(0));
  // A node that lets go loses its factor; one that comes takes the larger of its
  // neighbour's and the tool's median.
  fixture.begin_increment(q, 3., 10.);
  q[1] = .1;
  fixture.converge(q);
  fixture.contact.commit(q);
  BOOST_TEST(fixture.contact.committed()[0].penalty_factor == 0.);
  fixture.begin_increment(q, 4., 10.);
  q[1] = -1e-4;
  fixture.assemble(q);
  BOOST_TEST(fixture.contact.trial()[0].penalty_factor ==
             std::max(fixture.contact.trial()[1].penalty_factor, fixture.contact.committed()[1].penalty_factor));
}

BOOST_AUTO_TEST_CASE(who_touched_is_held_at_the_start)
{
  // Extrapolation opens the gap by more than the estimate of the force allows: the point acts as a spring both ways
  // until the first step has been made, and lets go if it still says so then. Resting on a tool without force is not
  // being held.
  for (const std::string enforcement : {"penalty", "active set"})
  {
    const bool is_multiplier = enforcement == "active set";
    const FakeSurface surface = row(2);
    InterfaceFixture fixture(surface, {"Enforcement=" + enforcement, "Allowed penetration=1e-3"}, flat);
    Vector q = place(fixture, 0., is_multiplier ? 0. : -1e-4);
    if (is_multiplier)
      for (unsigned int i = 0; i < 2; ++i)
        q[fixture.n_blank + i] = .1;
    fixture.contact.begin_stage(q, 0.);
    fixture.begin_increment(q, 1., stiffness);
    fixture.converge(q);
    fixture.contact.commit(q);
    BOOST_TEST(fixture.contact.committed()[0].force > 0.);
    fixture.contact.begin_increment(q, 2.);
    q[1] = .1;
    fixture.assemble(q);
    BOOST_TEST(fixture.contact.trial()[0].touching);
    BOOST_TEST((is_multiplier || fixture.contact.trial()[0].force < 0.));
    fixture.contact.prepare_step(Vector(fixture.n));
    fixture.assemble(q);
    BOOST_TEST(!fixture.contact.trial()[0].touching);
    BOOST_TEST(fixture.contact.trial()[1].touching);
  }
}

BOOST_AUTO_TEST_CASE(the_estimate_of_the_force)
{
  // On a plane the linear solve knows the force after the step; a part of the step leads to a part of the change.
  const FakeSurface surface = row(2);
  InterfaceFixture fixture(surface, constant, flat + Entries{"Force=1"});
  Vector q = place(fixture, 0., -.02), d(fixture.n);
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(q);
  BOOST_TEST(std::abs(fixture.contact.trial()[0].multiplier - 1.) < 1e-13);
  d[1] = -.03;
  d[3] = .05;
  d[fixture.n - 1] = .01; // the tool comes up
  fixture.contact.prepare_step(d);
  fixture.contact.advance(.5);
  BOOST_TEST(std::abs(fixture.contact.trial()[0].multiplier - (1. + .5 * 50. * .04)) < 1e-12);
  fixture.contact.advance(1.);
  q += d;
  fixture.assemble(q);
  BOOST_TEST(std::abs(fixture.contact.trial()[0].multiplier - fixture.contact.trial()[0].force) < 1e-12);
  // The second node is pulled off: tension is no contact.
  BOOST_TEST(!fixture.contact.trial()[1].touching);
  BOOST_TEST(fixture.contact.consistent(0.));
}

BOOST_AUTO_TEST_CASE(tension_is_no_solution)
{
  // The estimate says compression, but the node is above the tool: iterate with a tensile force, not a solution.
  const FakeSurface surface = row(1);
  InterfaceFixture fixture(surface, constant, flat);
  Vector q = place(fixture, 0., -.02);
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(q);
  fixture.assemble(place(fixture, 0., .01));
  BOOST_TEST(fixture.contact.trial()[0].touching);
  BOOST_TEST(fixture.contact.trial()[0].force < 0.);
  BOOST_TEST(!fixture.contact.consistent(0.));
}

BOOST_AUTO_TEST_CASE(continuation_of_a_first_touch)
{
  const FakeSurface surface = row(1);
  InterfaceFixture fixture(surface, constant, flat);
  const Vector q = place(fixture, 0., -.02);
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.contact.soften(1e-3);
  unsigned int rounds = 0;
  double last = 0.;
  do
  {
    fixture.converge(q);
    BOOST_TEST(fixture.contact.trial()[0].force > 5. * last);
    last = fixture.contact.trial()[0].force;
  } while (fixture.contact.correct_factors(q) > 0 && ++rounds < 20);
  BOOST_TEST(std::abs(last - 50. * .02) < 1e-13);
  BOOST_TEST((rounds > 1u && rounds < 10u));
}

BOOST_AUTO_TEST_CASE(continuation_of_points_that_touch)
{
  const FakeSurface surface = row(1);
  InterfaceFixture fixture(surface, constant, flat);
  const Vector q = place(fixture, 0., -.02);
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(q);
  fixture.contact.commit(q);
  fixture.begin_increment(q, 2., stiffness);
  fixture.contact.soften(.03);
  for (const double share : {.03, .3, 1.})
  {
    fixture.converge(q);
    BOOST_TEST(std::abs(fixture.contact.trial()[0].force - share * 50. * .02) < 1e-13);
    BOOST_TEST((fixture.contact.correct_factors(q) > 0) == (share < 1.));
  }
  // Another attempt is as stiff as ever.
  fixture.begin_increment(q, 2., stiffness);
  fixture.contact.soften(.03);
  fixture.begin_increment(q, 2., stiffness);
  fixture.converge(q);
  BOOST_TEST(std::abs(fixture.contact.trial()[0].force - 50. * .02) < 1e-13);
}

/// Down, along, back and up again on a plane: the trapezoidal work of the forces is what the energies say, to the last
/// digit, because everything is linear between the states. Factors change at the starts of increments and in
/// corrections; only their values at the ends of the increment count, and the accepted force.
/// @param accepted what the blank does once it is accepted (with the number of the increment)
static ContactEnergy
balanced_work(FakeSurface &surface, const std::function<void(unsigned int)> &accepted)
{
  InterfaceFixture fixture(
    surface,
    {"Enforcement=penalty", "Allowed penetration=1e-3 + if(t > 5, 2e-3, 0)", "Allowed elastic slip=1e-3"},
    flat + Entries{"Friction coefficient=.2"});
  Vector q = place(fixture, 0., 0.);
  fixture.contact.begin_stage(q, 0.);
  Eigen::VectorXd committed = Eigen::VectorXd::Zero(fixture.n);
  double work = 0.;
  unsigned int k = 0, corrected = 0, sliding = 0;
  const auto go = [&](const double x, const double z) {
    const Vector next = place(fixture, x, z);
    fixture.begin_increment(q, ++k, stiffness);
    fixture.converge(q);
    fixture.converge(next);
    for (unsigned int round = 0; round < 3 && fixture.contact.correct_factors(q) > 0; ++round)
    {
      fixture.converge(next);
      ++corrected;
    }
    const auto now = fixture.converge(next).residual;
    for (unsigned int i = 0; i < fixture.n; ++i)
      work += .5 * (now[i] + committed[i]) * (next[i] - q[i]);
    committed = now;
    q = next;
    fixture.contact.commit(q);
    accepted(k);
    sliding += fixture.contact.committed()[0].touching && !fixture.contact.committed()[0].sticking;
    const auto energy = fixture.contact.energy();
    // The work done on the nodes, by changing the factors and by moving the faces, is in the springs or lost.
    BOOST_TEST(std::abs(work + energy.epsilon + energy.thickness - energy.stored - energy.friction) <
               1e-14 * (10. + std::abs(work) + std::abs(energy.epsilon)));
  };
  for (unsigned int i = 1; i <= 5; ++i)
    go(0., -5e-4 * i);
  for (unsigned int i = 1; i <= 20; ++i)
    go(1e-3 * i, -2.5e-3);
  for (unsigned int i = 1; i <= 20; ++i)
    go(.02 - 2e-3 * i, -2.4e-3);
  for (unsigned int i = 1; i <= 4; ++i)
    go(-.02, -2.4e-3 + 5e-4 * i);
  go(-.02, 0.);
  go(-.02, .1);
  // From an open gap into contact and out of it, each in one increment.
  go(-.02, -5e-4);
  go(-.02, .07);
  BOOST_TEST(corrected > 0u);
  BOOST_TEST(sliding > 10u);
  const auto energy = fixture.contact.energy();
  BOOST_TEST_MESSAGE("work " << work << ", friction " << energy.friction << ", factors " << energy.epsilon
                             << ", faces that moved " << energy.thickness);
  BOOST_TEST(energy.stored == 0.);
  BOOST_TEST(energy.friction > 0.);
  BOOST_TEST(energy.epsilon != 0.);
  return energy;
}

BOOST_AUTO_TEST_CASE(work_is_stored_or_dissipated)
{
  FakeSurface surface = row(2);
  BOOST_TEST(balanced_work(surface, [](unsigned int) {}).thickness == 0.);
}

BOOST_AUTO_TEST_CASE(work_on_points_that_are_put_elsewhere)
{
  // The accepted blank has another thickness, and places its points anew: the forces at both ends of the next increment
  // work on that, across the tool and along it.
  FakeSurface surface = row(2);
  const auto put_elsewhere = [&](const unsigned int k) {
    surface.offset += k % 3 == 0 ? 2e-4 : -7e-5;
    for (Point2 &X : surface.X)
      X += Tensor1({k % 4 == 0 ? -5e-4 : 3e-4, k % 5 == 0 ? 1e-4 : -3e-5});
  };
  BOOST_TEST(std::abs(balanced_work(surface, put_elsewhere).thickness) > 1e-5);
}

BOOST_AUTO_TEST_CASE(work_of_normal_forces_on_a_round_tool)
{
  // A point goes around a circle in long increments, lets go and comes back: its forces work on straight ways, springs
  // store what the gap changes by, and the account has the difference.
  const FakeSurface surface(1);
  InterfaceFixture fixture(surface, constant, {"Shape=circle", "Radius=1", "Side=bottom", "Position z=0"});
  const auto at = [&](const double angle, const double p) {
    Vector q(fixture.n);
    q[0] = (1. - p) * std::sin(angle);
    q[1] = (1. - p) * std::cos(angle);
    return q;
  };
  Vector q = at(-.3, -.02);
  fixture.contact.begin_stage(q, 0.);
  Eigen::VectorXd committed = Eigen::VectorXd::Zero(fixture.n);
  double work = 0.;
  unsigned int k = 0;
  const auto to = [&](const Vector &next) {
    fixture.begin_increment(q, ++k, stiffness);
    const auto now = fixture.converge(next).residual;
    for (unsigned int i = 0; i < fixture.n; ++i)
      work += .5 * (now[i] + committed[i]) * (next[i] - q[i]);
    committed = now;
    fixture.contact.commit(q = next);
    const ContactEnergy &energy = fixture.contact.energy();
    BOOST_TEST(std::abs(work + energy.epsilon - energy.stored) < 1e-14);
    BOOST_TEST(energy.thickness == 0.);
  };
  for (const auto &[angle, p] :
       {std::pair(-.1, .02), {.2, .005}, {.25, .03}, {.4, -.1}, {.5, -.03}, {.3, .01}, {.1, -.001}, {0., .02}})
    to(at(angle, p));
  // Straight on past the top: an open gap of .03, which nothing has pushed open. What the spring held is lost.
  const double stored = fixture.contact.energy().stored, before = fixture.contact.energy().epsilon;
  Vector past = q;
  past[0] = .3;
  to(past);
  BOOST_TEST(fixture.contact.n_touching() == 0u);
  BOOST_TEST(std::abs(stored - .5 * 50. * .02 * .02) < 1e-14);
  BOOST_TEST(std::abs(fixture.contact.energy().epsilon - before + stored) < 1e-14);
}

BOOST_AUTO_TEST_CASE(work_along_a_face_that_climbs_over_a_round_tool)
{
  // A node of a straight face, with a constant force, is on the way to the top of a circle and then past it. The force
  // F has the part F sin(angle) along the face, which resists before the top and pushes after it; way: R d(angle).
  FakeSurface surface(1);
  surface.face = ContactSurface::FaceDirection{Tensor1({1., 0.}), 0.};
  const auto climbing = [&](const double from, const double to) {
    InterfaceFixture fixture(surface, constant, {"Shape=circle", "Radius=1", "Side=bottom", "Position z=0"});
    constexpr double p = .01;
    Vector q(fixture.n);
    const auto go = [&](const double angle) {
      q[0] = (1. - p) * std::sin(angle);
      q[1] = (1. - p) * std::cos(angle);
    };
    go(from);
    fixture.contact.begin_stage(q, 0.);
    constexpr unsigned int n = 200;
    double force = 0., first = 0.;
    for (unsigned int k = 0; k <= n; ++k)
    {
      const Vector before = q;
      go(from + (to - from) * k / n);
      fixture.begin_increment(before, k + 1., stiffness);
      fixture.converge(q);
      fixture.contact.commit(q);
      force = fixture.contact.committed()[0].force;
      if (k == 0)
        first = fixture.contact.energy().climbing;
    }
    BOOST_TEST(force > 0.);
    return (fixture.contact.energy().climbing - first) / (force * (1. - p));
  };
  constexpr double a = .4;
  const double half = 1. - std::cos(a);
  BOOST_TEST(std::abs(climbing(-a, 0.) - half) < 1e-5 * half);
  BOOST_TEST(std::abs(climbing(a, 0.) - half) < 1e-5 * half);
  BOOST_TEST(std::abs(climbing(0., a) + half) < 1e-5 * half);
  BOOST_TEST(std::abs(climbing(-a, a)) < 1e-12);
  // A face whose offset grows along it is itself at an angle to its curve: there it touches.
  surface.face->offset_rate = -std::sin(.1);
  BOOST_TEST(climbing(-.1, 0.) < .02 * half);
  surface.face.reset();
  BOOST_TEST(climbing(-a, 0.) == 0.);
}

BOOST_AUTO_TEST_CASE(friction_work_does_not_depend_on_the_increments)
{
  // A node comes down on a tool, slides for a length and is lifted off, all in motion: the work is the force times that
  // length, wherever within its increment the node touches or leaves, also where the tool ends and there is no foot
  // point beyond.
  constexpr double length = .6, height = .02, limit = .2 * 50. * height;
  const Entries ending{"Shape=profile", "Points=-1 0; .6 0", "Side=bottom", "Position z=0"};
  for (const Entries &tool : {flat, ending})
    for (const unsigned int n_increments : {3u, 6u, 24u})
      BOOST_TEST_CONTEXT(tool[0] << ", increments over the length: " << n_increments)
      {
        const double step = length / n_increments;
        const FakeSurface surface = row(1);
        InterfaceFixture fixture(
          surface, constant + Entries{"Allowed elastic slip=1e-3"}, tool + Entries{"Friction coefficient=.2"});
        const auto at = [&](const double x) { return place(fixture, x, x < 0. || x > length ? .1 : -height); };
        Vector q = at(-1.5 * step);
        fixture.contact.begin_stage(q, 0.);
        for (unsigned int k = 0; k < n_increments + 3; ++k)
          go(fixture, q, at((k - .5) * step), k + 1.);
        BOOST_TEST(fixture.contact.n_touching() == 0u);
        BOOST_TEST(std::abs(fixture.contact.energy().friction - limit * length) < 1e-12);
        // Once the force came within the increment, once it went: each puts an error evenly between +-limit step/2.
        BOOST_TEST(std::abs(fixture.contact.energy().friction_error() - limit * step / std::sqrt(6.)) < 1e-12);
      }
}

BOOST_AUTO_TEST_CASE(friction_that_passes_from_node_to_node_is_certain)
{
  // The friction force of the tool is the same all the time: it does not matter when which node takes it over.
  const FakeSurface surface = row(2);
  InterfaceFixture fixture(
    surface, constant + Entries{"Allowed elastic slip=1e-3"}, flat + Entries{"Friction coefficient=.2"});
  const auto at = [&](const double x, const bool first) {
    Vector q = place(fixture, x, .1);
    q[first ? 1 : 3] = -.02;
    return q;
  };
  Vector q = at(0., true);
  fixture.contact.begin_stage(q, 0.);
  go(fixture, q, at(.1, true), 1.);
  const ContactEnergy start = fixture.contact.energy();
  for (unsigned int k = 2; k < 10; ++k)
    go(fixture, q, at(.1 * k, k % 2 == 1), k);
  BOOST_TEST(fixture.contact.committed()[0].touching);
  BOOST_TEST(start.friction_error() > 0.);
  BOOST_TEST(std::abs(fixture.contact.energy().friction_error() - start.friction_error()) < 1e-12);
  BOOST_TEST(std::abs(fixture.contact.energy().friction - start.friction - .8 * .2) < 1e-12);
}

BOOST_AUTO_TEST_CASE(sticking_creeps_less_than_allowed)
{
  const FakeSurface surface = row(1);
  InterfaceFixture fixture(
    surface, constant + Entries{"Allowed elastic slip=1e-4"}, flat + Entries{"Friction coefficient=.2"});
  Vector q = place(fixture, 0., -.1); // lambda = 5, limit 1
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(q);
  fixture.contact.commit(q);
  fixture.begin_increment(q, 2., stiffness);
  BOOST_TEST(std::abs(fixture.contact.trial()[0].tangential_factor - 1. / 1e-4) < 1e-8);
  fixture.converge(place(fixture, .99e-4, -.1));
  BOOST_TEST(fixture.contact.trial()[0].sticking);
  BOOST_TEST(fixture.contact.correct_factors(q) == 0u);
  // With more normal force it would stick and creep further: the factor is raised.
  fixture.converge(place(fixture, 3e-4, -.4));
  BOOST_TEST(fixture.contact.trial()[0].sticking);
  const double before = fixture.contact.trial()[0].tangential_factor;
  BOOST_TEST(fixture.contact.correct_factors(q) == 1u);
  BOOST_TEST(std::abs(fixture.contact.trial()[0].tangential_factor / before - 3. / .8) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_thicker_blank_pushes)
{
  FakeSurface surface(1, 0., .05);
  InterfaceFixture fixture(surface, constant, flat);
  const Vector q = place(fixture, 0., .04);
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(q);
  fixture.contact.commit(q);
  surface.offset += 1e-4;
  BOOST_TEST(std::abs(fixture.contact.committed()[0].force - .5) < 1e-14);
  fixture.begin_increment(q, 2., stiffness);
  fixture.converge(q);
  fixture.contact.commit(q);
  BOOST_TEST(std::abs(fixture.contact.committed()[0].force - .505) < 1e-14);
  BOOST_TEST(std::abs(fixture.contact.energy().thickness - 50. * .01005 * 1e-4) < 1e-15);
}

BOOST_AUTO_TEST_CASE(the_deepest_point_of_an_edge_over_an_arc)
{
  // A chord with ends of different depth, also with faces that give way with the force, outside and inside of a circle,
  // on both sides of the axis: against a search of the chord in small steps.
  for (const std::string concave : {"false", "true"})
    for (const std::string compliance : {"off", "on"})
      for (const double side : {1., -1.})
        for (const double depth : {2e-3, 9e-3, 6e-2})
          BOOST_TEST_CONTEXT("concave " << concave << ", compliance " << compliance << ", side of the axis " << side
                                        << ", depth " << depth)
          {
            FakeSurface surface(2);
            surface.area = 4.;
            surface.compliance = 8e-3;
            const auto at = [&](const double angle, const double p) {
              const double rho = concave == "true" ? 1. + p : 1. - p;
              return Point2(side * rho * std::sin(angle), (concave == "true" ? -1. : 1.) * rho * std::cos(angle));
            };
            surface.X = {at(.1, 1e-3), at(.3, depth)};
            InterfaceFixture fixture(
              surface,
              constant,
              {"Shape=circle", "Radius=1", "Side=bottom", "Position z=0", "Concave=" + concave,
               "Thickness compliance=" + compliance});
            const Vector q(fixture.n);
            fixture.contact.begin_stage(q, 0.);
            fixture.begin_increment(q, 1., stiffness);
            fixture.converge(q);
            fixture.contact.commit(q);
            BOOST_TEST(fixture.contact.n_touching() == 2u);

            double deepest = 0.;
            for (unsigned int k = 0; k <= 20000; ++k)
            {
              const double xi = k / 20000.;
              const Point2 x = surface.X[0] + xi * (surface.X[1] - surface.X[0]);
              const auto &points = fixture.contact.committed();
              const double force = (1. - xi) * points[0].force + xi * points[1].force;
              const double face = compliance == "off" ? 0. : -surface.compliance * force;
              deepest = std::max(deepest, face - fixture.contact.tool().project(x, 0., 0).distance);
            }
            BOOST_TEST(deepest > 0.);
            BOOST_TEST(std::abs(penetration_between_nodes(fixture.contact, q) - deepest) < 1e-10);
          }
}

BOOST_AUTO_TEST_CASE(results_of_an_interface)
{
  // Two nodes on a circle and the chord between them, which cuts it by the sagitta.
  FakeSurface surface(2);
  surface.area = 4.;
  const double a = .2;
  const double p = 1e-3;
  surface.X = {(1. - p) * Point2(std::sin(-a), std::cos(a)), (1. - p) * Point2(std::sin(a), std::cos(a))};
  InterfaceFixture fixture(surface, constant, {"Shape=circle", "Radius=1", "Side=bottom", "Position z=0"});
  const Vector q(fixture.n);
  const Tensor1 way = fixture.contact.projector().counterpart().way(q, 0.);
  BOOST_TEST(std::abs(fixture.contact.projector().closest(q, way).second + p) < 1e-14);
  fixture.contact.begin_stage(q, 0.);
  fixture.begin_increment(q, 1., stiffness);
  fixture.converge(q);
  fixture.contact.commit(q);
  BOOST_TEST(std::abs(penetration_between_nodes(fixture.contact, q) - (1. - (1. - p) * std::cos(a))) < 1e-9);
  for (const double pressure : contact_pressure(fixture.contact, fixture.contact.committed(), q, 2))
    BOOST_TEST(std::abs(pressure - 50. * p / 4.) < 1e-13);
  DenseTarget released(fixture.n, false);
  fixture.contact.release(q, released);
  BOOST_TEST(fixture.contact.n_touching() == 0u);
  BOOST_TEST(fixture.contact.energy().stored == 0.);
  for (const double pressure : contact_pressure(fixture.contact, fixture.contact.committed(), q, 2))
    BOOST_TEST(pressure == 0.);
}

BOOST_AUTO_TEST_CASE(a_tool_leaves_with_the_forces_of_the_last_equilibrium)
{
  // Whatever the law would say after the thickness was updated, for every rule and enforcement.
  for (const auto &enforcement : Registry<NormalLaw>::names())
    for (const auto &rule : Registry<PenaltyRule>::names())
      BOOST_TEST_CONTEXT(enforcement << ", " << rule)
      {
        FakeSurface surface(3, 0., .05);
        surface.compliance = 1e-5;
        for (unsigned int i = 0; i < 3; ++i)
          surface.X[i] = Point2(-.2 + .2 * i, -.055);
        InterfaceFixture fixture(surface,
                                 {"Enforcement=" + enforcement, "Penalty rule=" + rule},
                                 {"Shape=circle",
                                  "Radius=1",
                                  "Side=bottom",
                                  "Position z=-1.1",
                                  "Friction coefficient=.2"});
        Vector q(fixture.n);
        for (unsigned int i = 6; i < 9 && i < fixture.n; ++i)
          q[i] = 3.; // multipliers
        fixture.contact.begin_stage(q, 0.);
        fixture.begin_increment(q, 1., stiffness);
        q[0] = .01;
        q[2] = .02;
        const DenseTarget balanced = fixture.converge(q);
        BOOST_TEST_REQUIRE(fixture.contact.n_touching() > 0u);
        fixture.contact.commit(q);

        surface.offset = .06;
        DenseTarget again(fixture.n, false);
        fixture.contact.begin_increment(q, 1.);
        fixture.contact.assemble(q, again);
        if (enforcement == "penalty")
          BOOST_TEST((again.residual - balanced.residual).norm() > 1e-3);
        DenseTarget released(fixture.n, false);
        fixture.contact.release(q, released);
        for (unsigned int i = 0; i < 6; ++i)
          BOOST_TEST(released.residual[i] == balanced.residual[i]);
        BOOST_TEST(fixture.contact.n_touching() == 0u);
      }
}

BOOST_AUTO_TEST_CASE(a_blank_that_rests_on_a_tool_touches_it)
{
  // Whatever the last digit of the gap says, also at the origin: a tool driven by a force would find nothing to lean
  // on.
  for (const std::string radius : {".3", ".5", "1", "1.7", "50"})
    for (const double height : {0., .4, -3.})
      BOOST_TEST_CONTEXT("radius " << radius << ", height " << height)
      {
        FakeSurface surface(1, 0., .0175);
        surface.X[0] = Point2(0., height);
        std::ostringstream position;
        position << "Position z=" << std::setprecision(17) << height - .0175;
        InterfaceFixture fixture(
          surface, constant, {"Shape=hemispherical punch", "Side=bottom", "Radius=" + radius, position.str()});
        fixture.contact.begin_stage(Vector(fixture.n), 0.);
        fixture.begin_increment(Vector(fixture.n), 1., stiffness);
        fixture.assemble(Vector(fixture.n));
        BOOST_TEST(fixture.contact.n_touching() == 1u);
      }
}

BOOST_AUTO_TEST_CASE(nodes_without_area_have_no_contact)
{
  FakeSurface surface = row(1);
  surface.area = 0.;
  InterfaceFixture fixture(surface, constant, flat);
  fixture.contact.begin_stage(Vector(fixture.n), 0.);
  fixture.begin_increment(Vector(fixture.n), 1., stiffness);
  BOOST_TEST(fixture.converge(place(fixture, 0., -.1)).residual.norm() == 0.);
  BOOST_TEST(fixture.contact.n_touching() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
