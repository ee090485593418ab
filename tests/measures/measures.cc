// Gauges on sections of which radii, angles and lengths are known.
#include <deltaform/measures/measure.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/section.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <map>

using namespace deltaform;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  /// A path of lines and arcs, walked by directions (rad), a row for every unit of length.
  class Path
  {
  public:
    explicit Path(const double angle)
      : angle_(angle)
    {
      add_row();
    }

    /// @param radius positive: to the left; 0: straight
    Path &go(const unsigned int length, const double radius = 0.)
    {
      for (unsigned int i = 0; i < length; ++i)
      {
        const double turn = radius != 0. ? 1. / radius : 0.;
        const double chord = turn != 0. ? 2. * radius * std::sin(.5 * turn) : 1.;
        r_ += chord * std::cos(angle_ + .5 * turn);
        z_ += chord * std::sin(angle_ + .5 * turn);
        angle_ += turn;
        s_ += 1.;
        add_row();
      }
      return *this;
    }

    Table table{{"r", "z", "S0"}, {"length", "length", "length"}, {}};

  private:
    void add_row()
    {
      table.rows.push_back({r_, z_, s_});
    }

    double r_ = 3., z_ = -2., s_ = 0., angle_;
  };

  std::map<std::string, double> measured(const std::string &kind, const std::vector<std::string> &entries,
                                         const Table &now, const Table &before)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root().sub("gauge");
    std::map<std::string, double> result;
    for (const auto &[name, value] : MeasureRegistry::make(kind, section)->of(now, before))
      result[name] = value;
    return result;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(measures)

BOOST_AUTO_TEST_CASE(radius_of_an_arc)
{
  const Table part = Path(.3).go(10).go(30, 40.).go(10).table;
  BOOST_TEST(measured("arc", {"gauge/From=10", "gauge/To=40"}, part, part).at("radius") == 40.,
             boost::test_tools::tolerance(1e-10));
  // A line has none.
  BOOST_TEST(measured("arc", {"gauge/From=0", "gauge/To=10"}, part, part).empty());
}

BOOST_AUTO_TEST_CASE(angle_between_two_legs)
{
  const Table part = Path(.3).go(10).go(20, -20.).go(10).table; // turns by 1 rad to the right
  const auto angles = measured("angle", {"gauge/First leg=0 10", "gauge/Second leg=30 40"}, part, part);
  BOOST_TEST(angles.at("bend_angle") == -180. / pi, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(angles.at("included_angle") == 180. - 180. / pi, boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(legs_that_end_between_nodes)
{
  // Chords of one arc, of which the nodes nearest to their ends would miss 1.3 degrees.
  const Table part = Path(.3).go(40, 20.).table;
  const auto angles = measured("angle", {"gauge/First leg=0 2.4", "gauge/Second leg=20.5 33.3"}, part, part);
  BOOST_TEST(angles.at("bend_angle") == .5 * (20.5 + 33.3 - 2.4) / 20. * 180. / pi, boost::test_tools::tolerance(1e-4));
  // A leg ends with the blank, and has to begin on it.
  const auto measure = [&](const std::string &leg) {
    return measured("angle", {"gauge/First leg=0 2", "gauge/Second leg=" + leg}, part, part);
  };
  BOOST_TEST(measure("30 50").at("bend_angle") == measure("30 40").at("bend_angle"));
  BOOST_TEST(measure("40 50").empty());
  // A row that stands twice changes nothing.
  Table twice = part;
  twice.rows.insert(twice.rows.begin() + 20, part.rows[20]);
  BOOST_TEST(measured("angle", {"gauge/First leg=0 2.4", "gauge/Second leg=20.5 33.3"}, twice, part).at("bend_angle") ==
             angles.at("bend_angle"));
  // Without a first leg from the direction of r, which is 0.
  const auto from_r = measured("angle", {"gauge/Second leg=30 31"}, part, part);
  BOOST_TEST(from_r.at("bend_angle") == (.3 + 30.5 / 20.) * 180. / pi,
             boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(u_bend_with_springback)
{
  // Bottom, a bend to the wall, the wall as an arc, a bend to the flange. Formed, the wall stood straight.
  const auto quarter = [](const unsigned int n) { return n / (.5 * pi); };
  const Table formed = Path(0.).go(40).go(10, quarter(10)).go(80).go(10, -quarter(10)).go(40).table;
  const double wall = 400., lower = 85. * pi / 180.;
  const Table sprung = Path(0.).go(40).go(10, 10. / lower).go(80, wall).go(10, -quarter(10)).go(40).table;
  const auto result = measured("u-bend", {"gauge/Margin=15"}, sprung, formed);
  BOOST_TEST(result.at("rho") == wall, boost::test_tools::tolerance(1e-8));
  // The circle's tangents are taken where the wall began and ended at a margin from bottom and flange in height:
  // between two nodes.
  const double first = 15. - quarter(10);
  BOOST_TEST(result.at("theta1") == 180. - (lower + first / wall) * 180. / pi, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(result.at("theta2") == 180. - (.5 * pi - first / wall) * 180. / pi, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(result.at("flange_length") > 40.);
  BOOST_TEST(result.at("flange_length") < 40. + 2. * quarter(10));
}

BOOST_AUTO_TEST_CASE(a_flat_strip_is_no_u_bend)
{
  const Table flat = Path(0.).go(100).table;
  BOOST_TEST(measured("u-bend", {}, flat, flat).empty());
}

BOOST_AUTO_TEST_SUITE_END()
