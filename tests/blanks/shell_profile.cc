// What the table of the profile says of the edges of a shell.
#include "any_blank.h"

#include <algorithm>
#include <cmath>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double inner = 10., outer = 20.;

  /// A flat ring or disc whose every place moves outwards by c (R - inner)^2.
  struct Stretched
  {
    Stretched(const double inside, const Entries &more)
    {
      Entries entries{"Blank/Thickness=.5",
                      "Blank/Points=" + std::to_string(inside) + " 0; " + std::to_string(outer) + " 0",
                      "Blank/Elements=10",
                      "Material/Young's modulus=2e5",
                      "Material/Hardening/Law=linear",
                      "Material/Hardening/Initial flow stress=200",
                      "Material/Hardening/Hardening modulus=500"};
      entries.insert(entries.end(), more.begin(), more.end());
      blank = make_blank("shell", entries);
      Vector q(blank->n_dofs());
      const auto places = blank->positions(q);
      const auto role = roles(*blank);
      for (DofIndex i = 0; i < q.size(); ++i)
        if (role[i].node != invalid_index && role[i].axis == 0)
          q[i] = c * std::pow(places[role[i].node][0] - inside, 2);
      blank->begin_increment(0., 0.);
      residual(*blank, q);
      blank->commit(q);
      profile = blank->fields().profile(q);
    }

    double value(const std::string &name, const bool at_end) const
    {
      const auto at = std::find(profile.names.begin(), profile.names.end(), name) - profile.names.begin();
      return (at_end ? profile.rows.back() : profile.rows.front())[static_cast<std::size_t>(at)];
    }

    static constexpr double c = .004;
    std::unique_ptr<Blank> blank;
    Table profile;
  };
} // namespace

BOOST_AUTO_TEST_SUITE(shell_profile)

BOOST_AUTO_TEST_CASE(strains_are_those_of_the_edge)
{
  // Half an element away they are off by .004 and .002 (meridional, at either edge), and by .0017 (hoop, outer edge).
  for (const std::string degree : {"1", "2"})
    for (const std::string grading : {"1", "1+2*t", "3-2*t"})
      BOOST_TEST_CONTEXT("degree " << degree << ", lengths of elements " << grading)
      {
        const Stretched ring(inner, {"Blank/Degree=" + degree, "Blank/Grading=" + grading});
        const double slope = 2. * Stretched::c * (outer - inner);
        BOOST_TEST(std::abs(ring.value("eps_meridional", false)) < 3e-4);
        BOOST_TEST(std::abs(ring.value("eps_meridional", true) - std::log1p(slope)) < 3e-4);
        BOOST_TEST(std::abs(ring.value("eps_hoop", false)) < 3e-4);
        BOOST_TEST(std::abs(ring.value("eps_hoop", true) - std::log(ring.value("r", true) / outer)) < 3e-4);
        BOOST_TEST(ring.value("equivalent_plastic_strain", false) >= 0.);
        BOOST_TEST(std::abs(std::log(ring.value("thickness", true) / .5) - ring.value("eps_thickness", true)) < 1e-14);
      }
}

BOOST_AUTO_TEST_CASE(there_is_no_slope_on_the_axis)
{
  // u = c R^2 has one, and a disc that is stretched like this has a kink there: its first value is that of a point.
  const Stretched disc(0., {});
  BOOST_TEST(std::abs(disc.value("eps_meridional", false) - std::log1p(2. * Stretched::c)) < 1e-10);
  BOOST_TEST(std::abs(disc.value("eps_meridional", true) - std::log1p(2. * Stretched::c * outer)) < 3e-4);
}

BOOST_AUTO_TEST_SUITE_END()
