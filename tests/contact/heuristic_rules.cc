// The heuristics of others, held against their formulas.
#include "../materials/material_point.h"

#include <deltaform/contact/penalty_rule.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  std::unique_ptr<PenaltyRule> rule(const std::string &name, const std::vector<std::string> &entries = {})
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    return Registry<PenaltyRule>::make(name, section);
  }

  PenaltyInput touching(const double p, const double q, const double delta)
  {
    PenaltyInput input;
    input.stiffness = 7.;
    input.previous_factor = 3.;
    input.penetration = p;
    input.previous_penetration = q;
    input.delta = delta;
    return input;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(heuristic_rules)

BOOST_AUTO_TEST_CASE(element_stiffness)
{
  PenaltyInput input = touching(1., 0., .1);
  input.modulus = 200.;
  input.area = 3.;
  input.thickness = .5;
  BOOST_TEST(rule("element stiffness")->predict(input) == .1 * 200. * 3. / .5, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(rule("element stiffness", {"Stiffness factor=2"})->predict(input) == 2400.,
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(rule("element stiffness")->correct(input) == 3.);
}

BOOST_AUTO_TEST_CASE(proportional)
{
  const auto law = rule("proportional", {"Start factor=2", "Proportional tolerance=.1"});
  BOOST_TEST(law->correct(touching(.5, 0., .1)) == 15., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(law->correct(touching(.109, 0., .1)) == 3.);
  BOOST_TEST(law->predict(touching(0., 0., .1)) == 3.);
  PenaltyInput first = touching(0., 0., .1);
  first.previous_factor = 0.;
  BOOST_TEST(law->predict(first) == 14.);
}

BOOST_AUTO_TEST_CASE(gap_driven)
{
  const auto law = rule("gap driven");
  const auto near = boost::test_tools::tolerance(1e-13);
  BOOST_TEST(law->correct(touching(.9, 0., 1.)) == 3.); // within delta
  BOOST_TEST(law->correct(touching(20., 1., 1.)) == 6.); // jumped in
  BOOST_TEST(law->correct(touching(5., 5., 1.)) == 27., near); // stays near: 3 (2 + 1)^2
  BOOST_TEST(law->correct(touching(5., 9., 1.)) == 27., near); // falls, within ten delta
  BOOST_TEST(law->correct(touching(17., 19., 1.)) == 15., near); // falls, far away: 3 (4 + 1)
  BOOST_TEST(law->correct(touching(24., 20., 1.)) == 5., near); // grows: 2 q/p
}

BOOST_AUTO_TEST_SUITE_END()
