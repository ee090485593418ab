// A shell that lies within itself.
#include "any_blank.h"

#include <deltaform/blanks/fields.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// Two legs that face each other, three thicknesses apart, and an arc between them.
  std::unique_ptr<Blank> hairpin()
  {
    Entries entries = {"Blank/Symmetry=plane strain",
                       "Blank/Points=0 0; 20 0; 20 3; 0 3",
                       "Blank/Fillet radii=0, 1.4, 1.4, 0",
                       "Blank/Thickness=1",
                       "Blank/Elements=60",
                       "Material/Young's modulus=2e3"};
    entries.insert(entries.end(), elastic.begin(), elastic.end());
    return make_blank("shell", entries);
  }

  /// The upper leg goes down by @p way.
  Vector closed(const Blank &blank, const double way)
  {
    const auto start = blank.positions(Vector(blank.n_dofs()));
    Vector q(blank.n_dofs());
    for (unsigned int i = 0; i < q.size(); ++i)
    {
      Vector one(q.size());
      one[i] = 1.;
      const auto now = blank.positions(one);
      for (unsigned int n = 0; n < start.size(); ++n)
        if (start[n][1] > 3. - 1e-12 && now[n][1] > start[n][1])
          q[i] = -way;
    }
    return q;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(shell_overlap)

BOOST_AUTO_TEST_CASE(legs_that_are_closer_than_their_thickness)
{
  const auto blank = hairpin();
  const auto share = [&](const double way) { return blank->fields().overlap(closed(*blank, way)).share; };
  BOOST_TEST(share(0.) == 0.);
  BOOST_TEST(share(1.9) == 0.);
  // .8 and .1 apart; a little less at the slanted element where the leg begins.
  BOOST_TEST(std::abs(share(2.2) - .2) < .02);
  BOOST_TEST(std::abs(share(2.9) - .9) < .002);
}

BOOST_AUTO_TEST_CASE(parts_of_one_direction_may_be_close)
{
  // Elements that are shorter than the thickness.
  Entries entries = {"Blank/Points=0 0; 5 0", "Blank/Thickness=1", "Blank/Elements=50", "Material/Young's modulus=2e3"};
  entries.insert(entries.end(), elastic.begin(), elastic.end());
  const auto flat = make_blank("shell", entries);
  BOOST_TEST(flat->fields().overlap(Vector(flat->n_dofs())).share == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
