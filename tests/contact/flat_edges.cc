// Edges that lie flat on a straight part of the tool: their outermost points stand for them.
#include "fake_surface.h"

#include <deltaform/contact/contact_measures.h>
#include <deltaform/parameters/registry.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double delta = 1e-3;

  /// Edges of length 1, each with four points inside it; every point moves by itself.
  class Edges : public FakeSurface
  {
  public:
    explicit Edges(const unsigned int n_edges)
      : FakeSurface(4 * n_edges)
    {
      for (unsigned int i = 0; i < 4 * n_edges; ++i)
        X[i] = Point2(.25 * i, 0.);
      edges.clear();
      for (unsigned int e = 0; e < n_edges; ++e)
        edges.push_back({{e, e + 1, invalid_index}});
      area = .3;
      compliance = .02;
    }

    unsigned int points_per_edge() const override
    {
      return 4;
    }

    double point_weight(Side, const unsigned int i) const override
    {
      return i % 4 == 0 || i % 4 == 3 ? .1 : .4;
    }
  };

  /// Over a tool, in the first increment with the second edge bulged by @p bulge (length) towards the tool.
  struct Fixture
  {
    explicit Fixture(const Entries &tool_entries, const double bulge = 0., const unsigned int n_edges = 2)
      : surface(n_edges), interface(surface, {"Allowed penetration=" + std::to_string(delta)}, tool_entries), q(interface.n)
    {
      q[2 * 5 + 1] = -bulge;
      begin();
    }

    void begin()
    {
      interface.contact.begin_stage(q, 0.);
      interface.begin_increment(q, 1., 1e3);
    }

    std::vector<double> areas() const
    {
      std::vector<double> result;
      for (unsigned int i = 0; i < 8; ++i)
        result.push_back(interface.contact.point(q, i).area);
      return result;
    }

    Edges surface;
    InterfaceFixture interface;
    Vector q;
  };


  const std::vector<double> all{.3, .3, .3, .3}, outermost{1.5, 0., 0., 1.5};

  std::vector<double> both(const std::vector<double> &first, const std::vector<double> &second)
  {
    std::vector<double> result = first;
    result.insert(result.end(), second.begin(), second.end());
    return result;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(flat_edges)

BOOST_AUTO_TEST_CASE(the_outermost_points_have_half_of_the_area_each)
{
  const Fixture even(flat);
  BOOST_TEST(even.areas() == both(outermost, outermost), boost::test_tools::per_element());
  // A spring through the thickness behind an area: .02 of .3.
  BOOST_TEST(even.interface.contact.point(even.q, 0).compliance == .02 / 5., boost::test_tools::tolerance(1e-14));
  // Away from the tool does not matter.
  BOOST_TEST(Fixture(flat, -delta).areas() == both(outermost, outermost), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(deeper_between_them_than_a_tenth_of_delta)
{
  BOOST_TEST(Fixture(flat, .099 * delta).areas() == both(outermost, outermost), boost::test_tools::per_element());
  BOOST_TEST(Fixture(flat, .101 * delta).areas() == both(outermost, all), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(over_a_round_part_every_point_is_asked)
{
  BOOST_TEST(Fixture({"Shape=circle", "Radius=1e3", "Side=bottom", "Position z=-1e3"}).areas() == both(all, all),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(an_edge_that_is_flat_no_longer_has_all_its_points)
{
  Fixture fixture(flat);
  auto &contact = fixture.interface.contact;
  // All of it .5 delta in; the inner points of a flat edge have no force.
  for (unsigned int i = 0; i < 8; ++i)
    fixture.q[2 * i + 1] = -.5 * delta;
  fixture.q[2 * 5 + 1] -= .24 * delta;
  fixture.interface.assemble(fixture.q);
  for (const unsigned int i : {0, 3, 4, 7})
    BOOST_TEST(contact.trial()[i].touching);
  for (const unsigned int i : {1, 2, 5, 6})
    BOOST_TEST(!contact.trial()[i].touching);
  contact.correct_factors(fixture.q);
  BOOST_TEST(fixture.areas() == both(outermost, outermost), boost::test_tools::per_element());
  fixture.q[2 * 5 + 1] -= .02 * delta;
  fixture.interface.assemble(fixture.q);
  BOOST_TEST(contact.correct_factors(fixture.q) > 0U);
  BOOST_TEST(fixture.areas() == both(outermost, all), boost::test_tools::per_element());
  fixture.interface.assemble(fixture.q);
  BOOST_TEST(contact.trial()[5].touching);
  // It keeps them as long as one of the inner ones bears a force, flat or not.
  contact.commit(fixture.q);
  fixture.interface.begin_increment(fixture.q, 2., 1e3);
  BOOST_TEST(fixture.areas() == both(outermost, all), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(pressures_of_the_accepted_state_are_those_before_and_after_the_next_increment_begins)
{
  // The second edge begins bulged and ends hollow, on its ends: flat from the next increment on.
  Fixture fixture(flat, .2 * delta);
  auto &contact = fixture.interface.contact;
  BOOST_TEST(fixture.areas() == both(outermost, all), boost::test_tools::per_element());
  fixture.q = 0.;
  fixture.q[2 * 4 + 1] = fixture.q[2 * 7 + 1] = -.5 * delta;
  fixture.q[2 * 5 + 1] = fixture.q[2 * 6 + 1] = .1 * delta;
  fixture.interface.assemble(fixture.q);
  contact.commit(fixture.q);
  const auto pressures = [&]() {
    return contact_pressure(contact, contact.committed(), fixture.q, fixture.surface.n_nodes());
  };
  const std::vector<double> before = pressures();
  BOOST_TEST(before[4] > 0.);
  BOOST_TEST(contact.accepted_point(fixture.q, 0).area == 1.5);
  fixture.interface.begin_increment(fixture.q, 2., 1e3);
  BOOST_TEST(fixture.areas() == both(outermost, outermost), boost::test_tools::per_element());
  BOOST_TEST(contact.accepted_point(fixture.q, 0).area == 1.5);
  BOOST_TEST(pressures() == before, boost::test_tools::per_element());
  BOOST_TEST(contact.accepted_point(fixture.q, 4).area == .3);
}

BOOST_AUTO_TEST_CASE(edges_that_wake_one_another_are_awake_soon)
{
  // Whenever one has woken, its neighbour on the right is no longer flat.
  constexpr unsigned int n = 30;
  Fixture fixture(flat, 0., n);
  auto &contact = fixture.interface.contact;
  for (unsigned int i = 0; i < 4 * n; ++i)
    fixture.q[2 * i + 1] = -.5 * delta;
  std::vector<unsigned int> asleep{n};
  while (asleep.back() > 0)
  {
    const unsigned int next = n - asleep.back();
    fixture.q[2 * (4 * next + 1) + 1] -= .3 * delta;
    fixture.interface.assemble(fixture.q);
    BOOST_REQUIRE(contact.correct_factors(fixture.q) > 0U);
    unsigned int n_asleep = 0;
    for (unsigned int e = 0; e < n; ++e)
      n_asleep += contact.point(fixture.q, 4 * e + 1).area == 0.;
    asleep.push_back(n_asleep);
  }
  // Two alone, then with them those that begin closer than 1.5, 3, 6, 12, ... to one that was not flat any more.
  BOOST_TEST(asleep == (std::vector<unsigned int>{30, 29, 28, 26, 23, 17, 5, 0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(only_edges_whose_points_come_or_go_are_assembled_anew)
{
  Fixture fixture(flat);
  auto &contact = fixture.interface.contact;
  for (unsigned int i = 0; i < 8; ++i)
    fixture.q[2 * i + 1] = -(.2 + .1 * i) * delta;
  const DenseTarget before = fixture.interface.assemble(fixture.q);
  const Tensor1 force = contact.tool_force();
  const std::size_t set = contact.signature();
  Vector d(fixture.q.size());
  BOOST_TEST(!contact.foresee(fixture.q, d));
  // One end of the second edge leaves.
  d[2 * 7 + 1] = 2. * delta;
  BOOST_TEST(contact.foresee(fixture.q, d));
  const DenseTarget after = fixture.interface.assemble(fixture.q);
  BOOST_TEST(contact.signature() != set);
  BOOST_TEST(contact.status_changed());
  for (unsigned int i = 0; i < before.residual.size(); ++i)
    BOOST_TEST(after.residual[i] == (i == 2 * 7 + 1 ? 0. : before.residual[i]));
  BOOST_TEST(contact.tool_force()[1] == force[1] - before.residual[2 * 7 + 1],
             boost::test_tools::tolerance(1e-14));
  // Another one takes with it what is an edge away.
  const auto touching = [&] {
    std::vector<unsigned int> result;
    for (unsigned int i = 0; i < 8; ++i)
      if (contact.trial()[i].touching)
        result.push_back(i);
    return result;
  };
  fixture.interface.assemble(fixture.q);
  BOOST_TEST(touching() == (std::vector<unsigned int>{0, 3, 4}), boost::test_tools::per_element());
  d[2 * 4 + 1] = 2. * delta;
  contact.foresee(fixture.q, d);
  contact.peel(1);
  fixture.interface.assemble(fixture.q);
  BOOST_TEST(touching().empty());
  d[2 * 4 + 1] = 0.;
  // All come back.
  d[2 * 7 + 1] = 0.;
  BOOST_TEST(contact.foresee(fixture.q, d));
  const DenseTarget again = fixture.interface.assemble(fixture.q);
  BOOST_TEST(contact.signature() == set);
  for (unsigned int i = 0; i < before.residual.size(); ++i)
    BOOST_TEST(again.residual[i] == before.residual[i]);
  BOOST_TEST((again.matrix - before.matrix).norm() == 0.);
  // With other factors everything is.
  const double factor = contact.trial()[0].penalty_factor;
  fixture.interface.read_stiffness(fixture.q, 5e3);
  contact.predict_factors(fixture.q, nullptr);
  const ContactPointState &state = contact.trial()[0];
  BOOST_TEST(state.penalty_factor != factor);
  const DenseTarget stiffer = fixture.interface.assemble(fixture.q);
  BOOST_TEST(stiffer.residual[1] == state.penalty_factor * state.gap, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()
