// The thickness of a shell gives way to a tool as a spring in series with the contact: forces, tangent, energy.
#include "fake_surface.h"

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double give = .02, factor = 200., stiffness = 1e3;

  FakeSurface compliant_node()
  {
    FakeSurface surface(1);
    surface.X[0] = Point2(.3, 0.);
    surface.compliance = give;
    return surface;
  }

  const Entries constant = {"Penalty rule=constant", "Penalty factor=200", "Continuation=false"};

  Vector sunk(const InterfaceFixture &fixture, const double depth)
  {
    Vector q(fixture.n);
    q[1] = -depth;
    return q;
  }

  /// The node with a plate, at the start of its first increment.
  struct CompliantContact : InterfaceFixture
  {
    CompliantContact(const FakeSurface &surface,
                     const Entries &contact_entries,
                     const std::string &compliance = "Thickness compliance=on")
      : InterfaceFixture(surface, contact_entries, flat + Entries{compliance})
    {
      contact.begin_stage(sunk(*this, 0.), 0.);
      begin_increment(sunk(*this, 0.), 1., stiffness);
    }
  };
} // namespace

BOOST_AUTO_TEST_SUITE(compliance)

BOOST_AUTO_TEST_CASE(two_springs_in_series)
{
  const FakeSurface surface = compliant_node();
  for (const double share : {0., 1.})
  {
    const std::string entry = share > 0. ? "Thickness compliance=on" : "Thickness compliance=off";
    CompliantContact fixture(surface, constant + Entries{"Enforcement=penalty"}, entry);
    const DenseTarget target = fixture.converge(sunk(fixture, .1));
    const double stiff = 1. / (1. / factor + share * give);
    const ContactPointState &state = fixture.contact.trial()[0];
    BOOST_TEST(std::abs(state.force - .1 * stiff) < 1e-13);
    BOOST_TEST(std::abs(state.penetration() - .1 * stiff / factor) < 1e-15);
    BOOST_TEST(std::abs(target.matrix(1, 1) - stiff) < 1e-11);
    fixture.contact.commit(sunk(fixture, .1));
    BOOST_TEST(std::abs(fixture.contact.energy().stored - .5 * .1 * .1 * stiff) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(an_estimate_along_a_step_is_the_force_at_its_end)
{
  const FakeSurface surface = compliant_node();
  CompliantContact fixture(surface, constant + Entries{"Enforcement=penalty"});
  fixture.converge(sunk(fixture, .1));
  Vector d(fixture.n);
  d[1] = -.05;
  fixture.contact.prepare_step(d);
  fixture.contact.advance(1.);
  fixture.assemble(sunk(fixture, .15));
  const ContactPointState &state = fixture.contact.trial()[0];
  BOOST_TEST(std::abs(state.multiplier - state.force) < 1e-13);
}

BOOST_AUTO_TEST_CASE(an_exact_constraint_holds_at_the_compressed_face)
{
  const FakeSurface surface = compliant_node();
  CompliantContact fixture(surface, {"Enforcement=active set"});
  Vector q = sunk(fixture, .1);
  q[2] = .1 / give;
  DenseTarget target = fixture.assemble(q);
  BOOST_TEST(std::abs(target.residual[2]) < 1e-15);
  BOOST_TEST(std::abs(fixture.contact.trial()[0].gap) < 1e-15);
  BOOST_TEST(std::abs(target.matrix(2, 2) + give) < 1e-15);
  q[2] += .3;
  target = fixture.assemble(q);
  BOOST_TEST(std::abs(target.residual[2] + .3 * give) < 1e-15);
}

BOOST_AUTO_TEST_CASE(augmentation_leaves_the_compression)
{
  // A shift that is the force of the compressed sheet: no penetration is left.
  const FakeSurface surface = compliant_node();
  CompliantContact fixture(surface, constant + Entries{"Enforcement=augmented Lagrangian"});
  fixture.converge(sunk(fixture, .1));
  const double force = .1 / give;
  fixture.contact.set_shifts(&force);
  fixture.converge(sunk(fixture, .1));
  BOOST_TEST(std::abs(fixture.contact.trial()[0].force - force) < 1e-13);
  BOOST_TEST(std::abs(fixture.contact.trial()[0].gap) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
