// Augmented forms on springs: Uzawa's iterates in closed form, and what the shifted start and the acceleration make of
// them.
#include "fake_surface.h"

#include <deltaform/contact/augmentation.h>

#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double factor = 2., spring = 10.;

  /// A node on a spring that is pressed onto a plate by @p force: the exact reaction is the force less that of the
  /// spring.
  struct PressedNode
  {
    PressedNode(const std::string &enforcement, const unsigned int depth)
      : surface(1), fixture((surface.X[0] = Point2(1., 0.), surface),
                            {"Enforcement=" + enforcement,
                             "Penalty rule=constant",
                             "Continuation=false",
                             "Penalty factor=" + std::to_string(factor),
                             "Augmentation tolerance=1e-12",
                             "Allowed penetration=.1"},
                            {"Shape=plate", "Side=bottom", "Motion=0", "Position z=0"}),
        q(2), augmentation(depth, 100000)
    {
      fixture.contact.begin_stage(q, 0.);
    }

    /// Equilibrium spring z + force = lambda at the current shift, by Newton.
    double solve(const double force)
    {
      for (unsigned int k = 0; k < 20; ++k)
      {
        const DenseTarget contact = fixture.assemble(q);
        const double residual = spring * q[1] + force + contact.residual[1];
        Vector d(2);
        d[1] = -residual / (spring + contact.matrix(1, 1));
        fixture.contact.prepare_step(d);
        fixture.contact.advance(1.);
        q += d;
      }
      fixture.assemble(q);
      return fixture.contact.trial()[0].force;
    }

    void begin(const double time)
    {
      fixture.begin_increment(q, time, spring);
      augmentation.restart();
    }

    FakeSurface surface;
    InterfaceFixture fixture;
    Vector q;
    Augmentation augmentation;
  };
} // namespace

BOOST_AUTO_TEST_SUITE(augmentation)

BOOST_AUTO_TEST_CASE(uzawa_converges_at_its_rate)
{
  PressedNode node("augmented Lagrangian", 0);
  node.begin(.1);
  // lambda = s + eps p and k p = f - lambda: the error falls by k/(k + eps) per round.
  const double force = 5.;
  double error = force;
  for (unsigned int round = 0; round < 30; ++round)
  {
    error *= spring / (spring + factor);
    BOOST_TEST(node.solve(force) == force - error, boost::test_tools::tolerance(1e-11));
    BOOST_TEST(node.augmentation.update({&node.fixture.contact}) == 1u);
  }
}

BOOST_AUTO_TEST_CASE(acceleration_finds_the_same_point_sooner)
{
  PressedNode node("augmented Lagrangian", 5);
  node.begin(.1);
  unsigned int round = 0;
  for (; round < 30; ++round)
  {
    node.solve(5.);
    if (node.augmentation.update({&node.fixture.contact}) == 0)
      break;
  }
  BOOST_TEST(round <= 4u);
  BOOST_TEST(node.fixture.contact.trial()[0].force == 5., boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(the_shifted_start_continues_uzawa)
{
  // With eps = lambda_n/delta the shift eps delta is the last force: what follows is Uzawa's iteration from there.
  PressedNode node("adaptive compensated", 0);
  node.begin(.1);
  double force = .2; // = eps delta
  for (unsigned int round = 0; round < 400 && node.solve(force) >= 0.; ++round)
    if (node.augmentation.update({&node.fixture.contact}) == 0)
      break;
  BOOST_TEST(node.fixture.contact.trial()[0].force == force, boost::test_tools::tolerance(1e-9));
  node.fixture.contact.commit(node.q);

  node.begin(.2);
  BOOST_TEST(node.fixture.contact.trial()[0].shift == force, boost::test_tools::tolerance(1e-9));
  // At the same load nothing is left to do; at a larger one the error falls at Uzawa's rate.
  BOOST_TEST(node.solve(force) == force, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(std::abs(node.fixture.contact.trial()[0].gap) < 1e-9);
  const double larger = .25;
  double error = larger - force;
  for (unsigned int round = 0; round < 10; ++round)
  {
    error *= spring / (spring + factor);
    BOOST_TEST(node.solve(larger) == larger - error, boost::test_tools::tolerance(1e-8));
    node.augmentation.update({&node.fixture.contact});
  }
}

BOOST_AUTO_TEST_CASE(a_point_that_is_pulled_off_is_free)
{
  PressedNode node("adaptive compensated", 5);
  node.begin(.1);
  for (unsigned int round = 0; round < 50; ++round)
  {
    node.solve(.2);
    if (node.augmentation.update({&node.fixture.contact}) == 0)
      break;
  }
  node.fixture.contact.commit(node.q);
  node.begin(.2);
  unsigned int round = 0;
  for (; round < 50; ++round)
  {
    node.solve(-1.);
    if (node.augmentation.update({&node.fixture.contact}) == 0)
      break;
  }
  BOOST_TEST(round < 5u);
  BOOST_TEST(node.fixture.contact.trial()[0].force == 0.);
  BOOST_TEST(node.q[1] == .1, boost::test_tools::tolerance(1e-12)); // spring alone
}

BOOST_AUTO_TEST_SUITE_END()
