#include "scene_text.h"

#include <deltaform/contact/contact_interface.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  const std::string punch_face = "  set Shape = plate\n  set Side = top\n  set Position z = thickness/2\n",
                    die_face = "  set Shape = plate\n  set Side = bottom\n  set Position z = -thickness/2\n";

  std::string tools(const std::string &names, const std::string &sections)
  {
    return " set Names = " + names + "\n" + sections;
  }

  const std::string punch_and_die = tools("punch, die", tool("punch", punch_face) + tool("die", die_face));

  std::string fine(const std::string &text)
  {
    return text + "subsection Contact\n set Allowed penetration = 1e-6*thickness\nend\n";
  }

  /// The strip is held at its start alone.
  std::string let_go(std::string text)
  {
    const std::string held = "Boundary = end\n  set Component = r", free = "Boundary = start\n  set Component = z";
    return text.replace(text.find(held), held.size(), free);
  }

  bool points_move_in(const std::string &text)
  {
    return ReadScene(text).scene->actors.blank->surface().points_move();
  }
} // namespace

BOOST_AUTO_TEST_SUITE(where_points_move)

BOOST_AUTO_TEST_CASE(is_where_a_strip_slides_freely)
{
  BOOST_TEST(points_move_in(fine(let_go(strip(punch_and_die)))));
  BOOST_TEST(!points_move_in(fine(strip(punch_and_die))), "both ends are held");
  BOOST_TEST(!points_move_in(let_go(strip(punch_and_die))), "the default delta is coarse");
  const std::string pushed = tools("punch, die", tool("punch", punch_face + "  set Force = 1\n") + tool("die", die_face));
  BOOST_TEST(!points_move_in(fine(let_go(strip(pushed)))), "a tool has a force");
  const std::string clamped =
    tools("punch, die, holder", tool("punch", punch_face) + tool("die", die_face) + tool("holder", punch_face));
  BOOST_TEST(!points_move_in(fine(let_go(strip(clamped)))), "a holder lies beside the punch");
  const std::string rigid =
    tools("punch, die", tool("punch", punch_face + "  set Thickness compliance = off\n") + tool("die", die_face));
  BOOST_TEST(!points_move_in(fine(let_go(strip(rigid)))), "the sheet is rigid through its thickness");
  BOOST_TEST(!points_move_in(fine(let_go(strip(punch_and_die, "set Elements = 20\n set Contact points = nodes\n")))),
             "the scene says where they are");
}

BOOST_AUTO_TEST_SUITE_END()
