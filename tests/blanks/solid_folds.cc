// Cells of a solid that are turned inside out at a corner, whatever their points of integration say.
#include "any_blank.h"

#include <deltaform/blanks/fields.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// Two by two square cells of side 1 in plane strain.
  std::unique_ptr<Blank> four_squares(const std::string &degree)
  {
    Entries entries = {"Blank/Symmetry=plane strain",
                       "Blank/Degree=" + degree,
                       "Blank/Points=0 1; 2 1",
                       "Blank/Thickness=2",
                       "Blank/Elements=2",
                       "Blank/Elements through thickness=2",
                       "Material/Young's modulus=2e3"};
    entries.insert(entries.end(), elastic.begin(), elastic.end());
    return make_blank("solid", entries);
  }

  /// The node that lies at @p from is moved by @p way.
  Vector moved(const Blank &blank, const Point2 &from, const Tensor1 &way)
  {
    const auto start = blank.positions(Vector(blank.n_dofs()));
    Vector q(blank.n_dofs());
    for (unsigned int i = 0; i < q.size(); ++i)
    {
      Vector one(q.size());
      one[i] = 1.;
      const auto now = blank.positions(one);
      for (unsigned int n = 0; n < start.size(); ++n)
        if (start[n].distance(from) < 1e-12)
          q[i] += (now[n] - start[n]) * way;
    }
    return q;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(solid_folds)

BOOST_AUTO_TEST_CASE(a_corner_beyond_the_diagonal)
{
  const auto blank = four_squares("1");
  const auto share = [&](const double way) {
    return blank->fields().folded_cells(moved(*blank, Point2(1., 1.), Tensor1({way, way}))).share;
  };
  BOOST_TEST(share(0.) == 0.);
  BOOST_TEST(share(-.49) == 0.); // the middle of the cell at the origin, at its diagonal: .5
  // Beyond it, the corner of the cell at the origin is more than half a turn: of four cells with the areas .49, 1, 1
  // and 1.51 it is one.
  BOOST_TEST(share(-.51) == .49 / 4., boost::test_tools::tolerance(1e-12));
  const FoldedCells cells = blank->fields().folded_cells(moved(*blank, Point2(1., 1.), Tensor1({.6, .6})));
  BOOST_TEST(cells.place.distance(Point2(1.5, 1.5)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(the_middle_of_an_edge_beyond_its_quarter)
{
  // dx/dxi at the end of an edge is 4 (x_m - x) - (x_o - x): it vanishes where the middle lies at the quarter.
  const auto blank = four_squares("2");
  const auto share = [&](const double way) {
    return blank->fields().folded_cells(moved(*blank, Point2(.5, 0.), Tensor1({way, 0.}))).share;
  };
  BOOST_TEST(share(.24) == 0.);
  BOOST_TEST(share(-.24) == 0.);
  BOOST_TEST(share(.26) == .25, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(share(-.26) == .25, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
