#include <deltaform/limits/necking.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace deltaform;

namespace
{
  /// A bar of five nodes in tension, of Hollomon's metal tau = eps^n, whose node 3 has the strain @p neck.
  std::vector<SheetSection> bar(const double n, const double rest, const double neck)
  {
    std::vector<SheetSection> sections;
    for (unsigned int i = 0; i < 5; ++i)
    {
      const double strain = i == 3 ? neck : rest;
      sections.push_back({.1 * i, .1 * i, std::exp(-strain / 2), strain, strain / 2, std::pow(strain, n)});
    }
    return sections;
  }

  std::string
  finding(const double n, const double rest, const double neck, const double next_rest, const double next_neck)
  {
    NeckingWatch watch;
    watch.observe(bar(n, rest, neck));
    watch.observe(bar(n, next_rest, next_neck));
    return watch.finding();
  }
} // namespace

BOOST_AUTO_TEST_SUITE(necking)

BOOST_AUTO_TEST_CASE(force_passes_its_maximum_at_strain_n)
{
  // Considere: tau = eps^n has the largest force at eps = n.
  BOOST_TEST(finding(.2, .15, .18, .15, .199) == "");
  const std::string found = finding(.2, .15, .21, .15, .22);
  BOOST_TEST(found.find("node 3 at R0 = 0.3") == 0u);
  BOOST_TEST(found.find("necks") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_sheet_that_thins_evenly_does_not_neck)
{
  BOOST_TEST(finding(.2, .3, .31, .31, .32) == "");
}

BOOST_AUTO_TEST_CASE(unloading_is_no_neck)
{
  BOOST_TEST(finding(.2, .15, .22, .15, .21) == "");
}

BOOST_AUTO_TEST_CASE(falling_stress_is_no_neck)
{
  // The section stretches and thins, but its stress falls: a sheet that is unloaded or bent back.
  NeckingWatch watch;
  watch.observe(bar(.2, .15, .21));
  auto next = bar(.2, .15, .22);
  next[3].stress -= .05;
  watch.observe(next);
  BOOST_TEST(watch.finding() == "");
}

BOOST_AUTO_TEST_CASE(a_neck_in_one_of_the_two_elements_at_a_node)
{
  // Perfectly plastic, tau = 1. Only the element after node 3 stretches, by .01; the force falls to exp(-.01), in the
  // element before it too, which unloads. The node has the mean of both.
  const auto strip = [](const double neck) {
    auto sections = bar(.2, .15, .21);
    const double fall = -std::expm1(.2 - neck);
    sections[3].stretch = .5 * (.2 + neck);
    sections[3].stress = .5 * ((1. - fall) + 1.);
    sections[3].thickness = std::exp(-neck);
    sections[3].thinning = neck;
    return sections;
  };
  NeckingWatch watch;
  watch.observe(strip(.2));
  watch.observe(strip(.21));
  BOOST_TEST(watch.finding().find("node 3") == 0u);
}

BOOST_AUTO_TEST_CASE(a_neck_at_once_is_told_and_not_remembered)
{
  // From .1, below the maximum at .2, to 1.2: the force falls from .571 to .312.
  NeckingWatch watch;
  watch.observe(bar(.2, .1, .1));
  const std::string found = watch.at_once(bar(.2, .1, 1.2));
  BOOST_TEST(found.find("node 3 at R0 = 0.3 necks at once: its thickness falls from 0.9512 to 0.5488 while its section "
                        "force falls by 45 %") == 0u);
  BOOST_TEST(watch.finding() == "");
  BOOST_TEST(watch.suspicion() == "");
  // To .25 the force grows as a whole; evenly; bent back; another mesh; no sheet; nothing known.
  BOOST_TEST(watch.at_once(bar(.2, .1, .25)) == "");
  BOOST_TEST(watch.at_once(bar(.2, 1.2, 1.2)) == "");
  auto bent = bar(.2, .1, 1.2);
  bent[3].stress = -.1;
  BOOST_TEST(watch.at_once(bent) == "");
  auto refined = bar(.2, .1, 1.2);
  refined.push_back(refined.back());
  BOOST_TEST(watch.at_once(refined) == "");
  BOOST_TEST(watch.at_once({}) == "");
  BOOST_TEST(NeckingWatch().at_once(bar(.2, .1, 1.2)) == "");
}

BOOST_AUTO_TEST_CASE(a_fall_of_the_force_by_more_than_twice_the_stretch_is_no_neck_at_once)
{
  // Stretched by .4 a section keeps exp(-.8) = .449 of its force at least, a small step has to say the same.
  const auto keeps = [](const double stretch, const double share) {
    NeckingWatch watch;
    auto sections = bar(.2, .1, .1);
    watch.observe(sections);
    const double force = sections[3].stress * std::exp(-.1);
    sections[3].stretch += stretch;
    sections[3].thinning += stretch / 2;
    sections[3].thickness *= std::exp(-stretch / 2);
    sections[3].stress = share * force * std::exp(.1 + stretch);
    return watch.at_once(sections);
  };
  BOOST_TEST(keeps(.4, .46) != "");
  BOOST_TEST(keeps(.4, .44) == "");
  BOOST_TEST(keeps(.004, .993) != "");
  BOOST_TEST(keeps(.004, .991) == "");
}

BOOST_AUTO_TEST_CASE(a_run_that_stops_soon_after_a_neck_has_it_as_its_likely_cause)
{
  const auto suspicion_after = [](const unsigned int increments, const double step) {
    NeckingWatch watch;
    watch.observe(bar(.2, .15, .21));
    watch.observe(bar(.2, .15, .22));
    auto next = bar(.2, .15, .22);
    for (unsigned int k = 0; k < increments; ++k)
    {
      next[3].thickness -= step;
      next[3].stress *= .9; // no neck by itself
      watch.observe(next);
    }
    BOOST_TEST((increments == 0 || watch.finding().empty()));
    return watch.suspicion();
  };
  BOOST_TEST(suspicion_after(0, 0.).find("node 3") == 0u);
  BOOST_TEST(suspicion_after(5, .01).find("node 3") == 0u);
  BOOST_TEST(suspicion_after(5, .01).find("the thinnest place has") != std::string::npos);
  BOOST_TEST(suspicion_after(6, .01) == "");
  BOOST_TEST(suspicion_after(5, -.001) == "");
  BOOST_TEST(NeckingWatch().suspicion() == "");
}

BOOST_AUTO_TEST_CASE(torn_is_what_necks_for_some_increments_and_loses_its_force)
{
  // F = eps^n exp(-eps), past its maximum at .2: from .3 to .35 it falls by 1.9 %, from .21 to .25 by .3 %.
  const auto torn_after = [](const double start, const double step, const unsigned int increments) {
    NeckingWatch watch;
    for (unsigned int k = 0; k <= increments; ++k)
      watch.observe(bar(.2, .15, start + k * step));
    return watch.torn();
  };
  BOOST_TEST(!torn_after(.3, .01, 4));
  BOOST_TEST(torn_after(.3, .01, 5));
  BOOST_TEST(!torn_after(.3, .05, 1));
  // Many increments that lose next to nothing.
  BOOST_TEST(!torn_after(.21, .001, 40));
  BOOST_TEST(torn_after(.21, .001, 100));
}

BOOST_AUTO_TEST_CASE(a_neck_goes_on_over_a_refinement)
{
  // After every other increment the mesh is refined at the end of the bar, at the same time.
  NeckingWatch watch;
  unsigned int n_more = 0;
  for (unsigned int k = 0; k <= 5; ++k)
  {
    BOOST_TEST(!watch.torn());
    auto sections = bar(.2, .15, .3 + k * .01);
    sections.insert(sections.end(), n_more, sections.back());
    watch.observe(sections);
    if (k % 2 == 1 && k < 5)
    {
      sections.push_back(sections.back());
      ++n_more;
      watch.observe(sections);
      BOOST_TEST(watch.finding() == "");
    }
  }
  BOOST_TEST(watch.torn());
  BOOST_TEST(watch.finding().find("node 3 at R0 = 0.3 necks") == 0U);
}

BOOST_AUTO_TEST_CASE(a_neck_that_stops_is_not_torn)
{
  NeckingWatch watch;
  double strain = .3;
  for (unsigned int k = 0; k < 20; ++k)
  {
    strain += k % 4 == 3 ? -.001 : .02; // unloads every fourth time
    watch.observe(bar(.2, .15, strain));
    BOOST_TEST(!watch.torn());
  }
}

namespace
{
  /// 81 nodes, 5 apart, perfectly plastic: each increment stretches node 20, in the middle, by .01 and the others by the
  /// bell curve of the next of @p widths about it. Nodes before @p end touch a tool. Nodes of odd number come last.
  NeckingWatch zone(const std::vector<double> &widths, const double h0 = 1., const double end = 400.)
  {
    constexpr int n = 81;
    std::vector<SheetSection> sections;
    for (int k = 0; k < n; ++k)
    {
      const double s = 5. * (k < 41 ? 2 * k : 2 * (k - 41) + 1);
      sections.push_back({s, s, h0, 0., 0., 1., s < end ? .1 : 0.});
    }
    NeckingWatch watch;
    watch.observe(sections);
    for (const double width : widths)
    {
      for (SheetSection &section : sections)
      {
        const double x = (section.arc - 200.) / width;
        section.stretch += .01 * std::exp(-x * x);
        section.thinning = section.stretch;
        section.thickness = h0 * std::exp(-section.thinning);
      }
      watch.observe(sections);
      BOOST_TEST(watch.finding().find("node 20 at R0 = 200 necks") == 0u);
      BOOST_TEST(!(watch.torn() && !watch.holding().empty()));
    }
    return watch;
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_wide_zone_is_held_by_the_tool_on_which_it_lies)
{
  const NeckingWatch watch = zone(std::vector<double>(10, 20.));
  BOOST_TEST(!watch.torn());
  // Perfectly plastic: F falls by as much as it stretches.
  BOOST_TEST(watch.holding().find("the section of node 20 at R0 = 200 stretches although its force falls") == 0u);
  BOOST_TEST(watch.holding().find("by 10 %") != std::string::npos);
  BOOST_TEST(watch.holding().find("at a thickness of 0.9048") != std::string::npos);
  // More than half of it has to lie on the tool.
  BOOST_TEST(!zone(std::vector<double>(10, 20.), 1., 210.).torn());
  BOOST_TEST(zone(std::vector<double>(10, 20.), 1., 190.).torn());
  BOOST_TEST(zone(std::vector<double>(10, 20.), 1., 190.).holding() == "");
}

BOOST_AUTO_TEST_CASE(a_zone_that_a_tool_may_hold_is_no_neck_at_once)
{
  // Perfectly plastic; the thinnest node stretches by .2 of a sudden, in a zone of that width. Tools touch up to @p end.
  const auto at_once = [](const double width, const double end) {
    std::vector<SheetSection> sections;
    for (int k = 0; k < 81; ++k)
      sections.push_back({5. * k, 5. * k, 1., 0., 0., 1., 5. * k < end ? .1 : 0.});
    NeckingWatch watch;
    watch.observe(sections);
    for (SheetSection &section : sections)
    {
      const double x = (section.arc - 200.) / width;
      section.stretch = section.thinning = .2 * std::exp(-x * x);
      section.thickness = std::exp(-section.thinning);
      section.contact_pressure = 0.; // is not known
    }
    return watch.at_once(sections);
  };
  BOOST_TEST(at_once(20., 400.) == "");
  BOOST_TEST(at_once(20., 190.).find("node 40 at R0 = 200 necks at once") == 0u);
  BOOST_TEST(at_once(5., 400.).find("node 40 at R0 = 200 necks at once") == 0u);
}

BOOST_AUTO_TEST_CASE(a_narrow_zone_tears_on_a_tool_too)
{
  // The zone is sqrt(pi) times as wide as the bell curve; one of ten thicknesses is a neck.
  BOOST_TEST(zone(std::vector<double>(5, 5.)).torn());
  BOOST_TEST(!zone(std::vector<double>(4, 5.)).torn());
  BOOST_TEST(zone(std::vector<double>(5, 10.), 2.).torn());
  BOOST_TEST(!zone(std::vector<double>(5, 10.)).torn());
}

BOOST_AUTO_TEST_CASE(a_zone_that_narrows_by_a_tenth_tears)
{
  BOOST_TEST(zone({20., 19.5, 19., 18.5, 17.9}).torn());
  BOOST_TEST(!zone({20., 19.5, 19., 18.5, 18.1}).torn());
  BOOST_TEST(!zone({20., 22., 24., 26., 28.}).torn());
  // Of the widest, not of the first.
  BOOST_TEST(zone({20., 22., 24., 26., 23.}).torn());
}

BOOST_AUTO_TEST_CASE(a_mesh_can_show_no_neck_narrower_than_its_elements)
{
  // One node of elements of fifty thicknesses thins: the zone is 5.6 wide. Four do: 13.3.
  BOOST_TEST(zone(std::vector<double>(5, 3.), .1).torn());
  BOOST_TEST(!zone(std::vector<double>(5, 7.5), .1).torn());
}

BOOST_AUTO_TEST_CASE(nothing_known_is_no_neck)
{
  NeckingWatch watch;
  BOOST_TEST(watch.finding() == "");
  watch.observe({});
  watch.observe(bar(.2, .1, .3));
  BOOST_TEST(watch.finding() == "");
}

BOOST_AUTO_TEST_SUITE_END()
