#include "../blanks/any_blank.h"

#include <deltaform/measures/probe.h>
#include <deltaform/parameters/section.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  Probe make_probe(const Blank &blank, const Entries &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    return Probe("here", tree.root().sub("here"), blank);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(probe)

BOOST_AUTO_TEST_CASE(a_place_of_the_blank)
{
  for_all_blanks({"Blank/Points=.3 0; 1.1 0", "Blank/Thickness=.01", "Blank/Elements=4", "Blank/Elements across=1"},
                 [](Blank &blank, const Entries &) {
                   const Table profile = blank.fields().profile(Vector(blank.n_dofs()));
                   const auto r_at = [&](const std::string &place) {
                     return make_probe(blank, {"here/Place=" + place, "here/Fields=r, thickness"}).values(profile);
                   };
                   BOOST_TEST(r_at("start")[0] == .3, boost::test_tools::tolerance(1e-12));
                   BOOST_TEST(r_at("end")[0] == 1.1, boost::test_tools::tolerance(1e-12));
                   BOOST_TEST(r_at("end")[1] == .01, boost::test_tools::tolerance(1e-9));
                   // Between two nodes, and the node nearest to a point.
                   BOOST_TEST(r_at("0.35")[0] == .65, boost::test_tools::tolerance(1e-12));
                   BOOST_TEST(r_at("0.72 0.1")[0] == .7, boost::test_tools::tolerance(1e-12));
                 });
}

BOOST_AUTO_TEST_CASE(what_is_not_there_is_refused)
{
  for_all_blanks({"Blank/Points=.3 0; 1.1 0", "Blank/Thickness=.01", "Blank/Elements=4"},
                 [](Blank &blank, const Entries &) {
                   BOOST_CHECK_THROW(make_probe(blank, {"here/Place=0.81"}), SceneError);
                   BOOST_CHECK_THROW(make_probe(blank, {"here/Place=middle"}), SceneError);
                   BOOST_CHECK_THROW(make_probe(blank, {"here/Place=1 2 3"}), SceneError);
                   BOOST_CHECK_THROW(make_probe(blank, {"here/Place=start", "here/Fields=temper"}), SceneError);
                 });
}

BOOST_AUTO_TEST_SUITE_END()
