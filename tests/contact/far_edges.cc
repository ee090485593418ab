// Edges that stay clear over several increments: left alone, and looked at again in time.
#include "fake_surface.h"

#include <deltaform/io/byte_stream.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double half_thickness = .05;

  /// A chain of straight edges along r with three points in each.
  class Strip : public ContactSurface
  {
  public:
    /// @param says_motion does it say how far an edge moves? If not, no edge is ever left alone.
    Strip(const unsigned int n_edges, const bool says_motion)
      : says_motion_(says_motion)
    {
      for (unsigned int e = 0; e < n_edges; ++e)
        edges_.push_back({{e, e + 1, invalid_index}});
    }

    unsigned int n_contact_dofs() const override
    {
      return 2 * n_nodes();
    }

    unsigned int n_nodes() const override
    {
      return edges_.size() + 1;
    }

    unsigned int n_contact_points(Side) const override
    {
      return 3 * edges_.size();
    }

    double modulus() const override
    {
      return 1e3;
    }

    double flow_stress(Side, unsigned int) const override
    {
      return .3;
    }

    void contact_point(const Vector &q,
                       const Side side,
                       const unsigned int i,
                       const ContactThickness thickness,
                       ContactPoint &point) const override
    {
      ++n_described;
      contact_place(q, side, i / 3, places_[i % 3], thickness, point);
      point.area = i % 3 == 1 ? 4. / 9. : 5. / 18.;
    }

    const std::vector<std::array<unsigned int, 3>> &contact_edges(Side) const override
    {
      return edges_;
    }

    unsigned int points_per_edge() const override
    {
      return 3;
    }

    void contact_place(const Vector &q,
                       Side,
                       const unsigned int e,
                       const double xi,
                       ContactThickness,
                       ContactPoint &point) const override
    {
      point = ContactPoint();
      point.n_nodes = 2;
      point.n_dofs = 4;
      point.offset = offset;
      point.thickness = 2. * offset;
      for (unsigned int a = 0; a < 2; ++a)
      {
        const double N = a == 0 ? 1. - xi : xi;
        point.nodes[a] = {e + a, N};
        for (unsigned int c = 0; c < 2; ++c)
        {
          const unsigned int k = 2 * a + c;
          point.dofs[k] = 2 * (e + a) + c;
          point.jacobian[k][c] = N;
          point.x[c] += N * ((c == 0 ? e + a : 0.) + q[point.dofs[k]]);
        }
      }
    }

    double largest_motion(Side, unsigned int, const std::array<double, ContactPoint::max_dofs> &change) const override
    {
      return says_motion_ ? std::max(std::hypot(change[0], change[1]), std::hypot(change[2], change[3]))
                          : std::numeric_limits<double>::infinity();
    }

    double offset = half_thickness;
    mutable unsigned int n_described = 0;

  private:
    bool says_motion_;
    std::vector<std::array<unsigned int, 3>> edges_;
    std::array<double, 3> places_{{.5 - std::sqrt(.15), .5, .5 + std::sqrt(.15)}};
  };

  /// A strip over a circle of radius 1 at the origin, with friction. It lies in it where it passes the top.
  struct Passage
  {
    Passage(const unsigned int n_edges, const bool says_motion, const double start = -.3, const double depth = .025)
      : strip(n_edges, says_motion),
        fixture(strip, {}, {"Shape=circle", "Radius=1", "Side=bottom", "Position z=0", "Friction coefficient=.3"}),
        q(fixture.n)
    {
      for (unsigned int k = 1; k < q.size(); k += 2)
        q[k] = 1. + half_thickness - depth;
      move(start);
      fixture.contact.begin_stage(q, 0.);
    }

    /// The whole strip along r.
    void move(const double way)
    {
      for (unsigned int k = 0; k < q.size(); k += 2)
        q[k] += way;
    }

    void begin(const unsigned int increment)
    {
      fixture.begin_increment(q, .01 * increment, 1e3);
    }

    /// An increment that moves the strip by @p way, in one step that is foreseen.
    DenseTarget advance(const unsigned int increment, const double way)
    {
      begin(increment);
      fixture.assemble(q);
      Vector d(q.size());
      for (unsigned int k = 0; k < q.size(); k += 2)
        d[k] = way;
      fixture.contact.foresee(q, d);
      fixture.contact.prepare_step(d);
      fixture.contact.advance(1.);
      q += d;
      const DenseTarget target = fixture.converge(q);
      fixture.contact.commit(q);
      return target;
    }

    const FarEdges &far() const
    {
      return fixture.contact.projector().far();
    }

    Strip strip;
    InterfaceFixture fixture;
    Vector q;
  };

  void compare(const ContactInterface &a, const ContactInterface &b)
  {
    BOOST_TEST(a.n_touching() == b.n_touching());
    for (unsigned int i = 0; i < a.n_points(); ++i)
      if (const ContactPointState &x = a.committed()[i], &y = b.committed()[i]; x.touching || y.touching)
      {
        BOOST_TEST(x.touching == y.touching);
        BOOST_TEST(x.force == y.force);
        BOOST_TEST(x.gap == y.gap);
        BOOST_TEST(x.tangential_force == y.tangential_force);
        BOOST_TEST(x.slip == y.slip);
        BOOST_TEST(x.position.distance(y.position) == 0.);
      }
  }

  std::string saved(const ContactInterface &contact)
  {
    ByteStream bytes;
    {
      boost::archive::binary_oarchive archive(bytes.stream());
      archive << contact;
    }
    return bytes.take();
  }

  void load(const std::string &bytes, ContactInterface &contact)
  {
    std::istringstream stream(bytes);
    boost::archive::binary_iarchive archive(stream);
    archive >> contact;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(far_edges)

BOOST_AUTO_TEST_CASE(a_strip_that_passes_is_the_same_and_asked_less)
{
  // Twelve edges pass one after the other, by small steps and some that are larger than an edge.
  Passage all(12, false), less(12, true);
  unsigned int n_all = 0, n_less = 0, n_touched = 0;
  std::size_t most_far = 0;
  for (unsigned int increment = 1; increment <= 80; ++increment)
  {
    const unsigned int before_all = all.strip.n_described, before_less = less.strip.n_described;
    const double way = increment % 20 == 0 ? -1.3 : -.08;
    const DenseTarget a = all.advance(increment, way), b = less.advance(increment, way);
    n_all += all.strip.n_described - before_all;
    n_less += less.strip.n_described - before_less;
    BOOST_TEST((a.residual - b.residual).norm() == 0.);
    BOOST_TEST((a.matrix - b.matrix).norm() == 0.);
    compare(all.fixture.contact, less.fixture.contact);
    BOOST_TEST(all.far().empty());
    most_far = std::max(most_far, less.far().far().size());
    n_touched += less.fixture.contact.n_touching();
  }
  BOOST_TEST(n_touched > 50u);
  BOOST_TEST(most_far >= 8u);
  BOOST_TEST(2 * n_less < n_all);
}

BOOST_AUTO_TEST_CASE(all_edges_are_near_where_nothing_touches)
{
  // A tool that touches nowhere is told how far it may go, by all points.
  Passage passage(12, true);
  passage.advance(1, -.01);
  passage.advance(2, -.01);
  BOOST_TEST(passage.far().far().size() >= 8u);
  for (unsigned int k = 1; k < passage.q.size(); k += 2)
    passage.q[k] += .1;
  passage.advance(3, 0.);
  BOOST_TEST(passage.fixture.contact.n_touching() == 0u);
  BOOST_TEST(passage.far().empty());
  const ContactInterface &contact = passage.fixture.contact;
  for (unsigned int i = 0; i < contact.n_points(); ++i)
    BOOST_TEST(contact.committed()[i].position.distance(contact.point(passage.q, i).x) < 1e-14);
}

BOOST_AUTO_TEST_CASE(an_edge_that_gets_thicker_is_looked_at_again)
{
  // The first point of the second edge is at r = .28, .077 above the circle.
  Passage passage(4, true, -.72 - (.5 - std::sqrt(.15)), .01);
  for (unsigned int increment = 1; increment <= 3; ++increment)
    passage.advance(increment, 0.);
  BOOST_TEST(passage.far().far().size() == 3u);
  passage.strip.offset = .07;
  passage.begin(4);
  BOOST_TEST(passage.far().far().size() == 3u);
  passage.strip.offset = .08;
  passage.begin(4);
  BOOST_TEST(passage.far().far().size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_saved_state_goes_on_in_the_same_way)
{
  Passage first(12, true);
  for (unsigned int increment = 1; increment <= 12; ++increment)
    first.advance(increment, -.08);
  BOOST_TEST(!first.far().empty());
  Passage second(12, true);
  const std::string bytes = saved(first.fixture.contact);
  load(bytes, second.fixture.contact);
  second.q = first.q;
  BOOST_TEST((saved(second.fixture.contact) == bytes));
  for (unsigned int increment = 13; increment <= 30; ++increment)
  {
    first.advance(increment, -.08);
    second.advance(increment, -.08);
  }
  BOOST_TEST((saved(second.fixture.contact) == saved(first.fixture.contact)));
  // That of a shorter strip names edges that do not exist, if it says that it has as many points.
  FarEdges edges;
  edges.reset(12);
  edges.add(first.far().far());
  std::ostringstream out;
  {
    boost::archive::binary_oarchive archive(out);
    archive << static_cast<const FarEdges &>(edges);
  }
  FarEdges shorter;
  shorter.reset(3);
  std::istringstream in(out.str());
  boost::archive::binary_iarchive archive(in);
  BOOST_CHECK_THROW(archive >> shorter, SceneError);
}

BOOST_AUTO_TEST_CASE(a_new_stage_looks_at_all)
{
  Passage passage(12, true);
  passage.advance(1, -.01);
  BOOST_TEST(!passage.far().empty());
  passage.fixture.contact.begin_stage(passage.q, 1.);
  BOOST_TEST(passage.far().empty());
  passage.advance(101, -.01);
  BOOST_TEST(!passage.far().empty());
  DenseTarget forces(passage.fixture.n);
  passage.fixture.contact.release(passage.q, forces);
  BOOST_TEST(passage.far().empty());
}

BOOST_AUTO_TEST_SUITE_END()
