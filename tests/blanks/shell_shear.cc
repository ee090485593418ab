// How much transverse shear a shell carries.
#include "any_blank.h"

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// A strip 10 long, whose second half is sheared by @p angle (rad).
  LargestShear sheared(const double angle, const Entries &more = {})
  {
    Entries entries{"Blank/Thickness=.5",
                    "Blank/Symmetry=plane strain",
                    "Blank/Points=0 0; 10 0",
                    "Blank/Elements=10",
                    "Material/Young's modulus=2.6e5",
                    "Material/Poisson's ratio=.3",
                    "Material/Hardening/Law=linear",
                    "Material/Hardening/Initial flow stress=200",
                    "Material/Hardening/Hardening modulus=500"};
    entries.insert(entries.end(), more.begin(), more.end());
    const auto blank = make_blank("shell", entries);
    Vector q(blank->n_dofs());
    const auto places = blank->positions(q);
    const auto role = roles(*blank);
    for (DofIndex i = 0; i < q.size(); ++i)
      if (role[i].node != invalid_index && role[i].axis == 1)
        q[i] = angle * std::max(places[role[i].node][0] - 5., 0.);
    blank->begin_increment(0., 0.);
    residual(*blank, q);
    blank->commit(q);
    return blank->fields().largest_shear(q);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(shell_shear)

BOOST_AUTO_TEST_CASE(is_that_of_timoshenko)
{
  // 5/6 G angle over the flow stress, G = 1e5
  for (const std::string degree : {"1", "2"})
    for (const double angle : {1e-3, -1e-3})
    {
      const LargestShear result = sheared(angle, {"Blank/Degree=" + degree});
      BOOST_TEST(result.share == 5. / 6. * 1e5 * 1e-3 / 200., boost::test_tools::tolerance(1e-5));
      BOOST_TEST((result.place > 5. && result.place < 10.));
    }
}

BOOST_AUTO_TEST_CASE(none_where_it_means_nothing)
{
  BOOST_TEST(sheared(0.).share < 1e-12);
  BOOST_TEST(sheared(1e-3, {"Blank/Membrane=true"}).share == 0.);
  BOOST_TEST(sheared(1e-3, {"Material/Model=linear elastic"}).share == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
