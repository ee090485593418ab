#include <deltaform/limits/ironing.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

namespace
{
  /// Three sections of a sheet that flows at 200; the second is pressed with @p clamping_pressure on both faces.
  std::vector<SheetSection> sheet(const double clamping_pressure)
  {
    std::vector<SheetSection> sections(3);
    for (auto &section : sections)
      section.flow_stress = 200.;
    sections[0].clamping_pressure = 10.;
    sections[1].clamping_pressure = clamping_pressure;
    sections[1].place = 7.;
    return sections;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(ironing)

BOOST_AUTO_TEST_CASE(two_increments_in_a_row_above_the_flow_stress)
{
  IroningWatch watch;
  watch.observe(sheet(201.));
  BOOST_TEST(watch.finding() == "");
  BOOST_TEST(watch.suspicion().find("node 1 at R0 = 7 ") == 0u);
  watch.observe(sheet(300.));
  BOOST_TEST(
    watch.finding().find("node 1 at R0 = 7 is pressed on both faces with 300, more than its flow stress of 200") == 0u);
}

BOOST_AUTO_TEST_CASE(less_than_the_flow_stress_does_not_iron)
{
  IroningWatch watch;
  for (unsigned int k = 0; k < 5; ++k)
    watch.observe(sheet(199.));
  BOOST_TEST(watch.finding() == "");
  // If the next increment cannot be solved, that is why.
  BOOST_TEST(watch.suspicion().find("with 199, close to its flow stress of 200") != std::string::npos);
  watch.observe(sheet(139.));
  BOOST_TEST(watch.suspicion() == "");
}

BOOST_AUTO_TEST_CASE(single_increments_do_not_count)
{
  IroningWatch watch;
  for (unsigned int k = 0; k < 6; ++k)
  {
    watch.observe(sheet(k % 2 == 0 ? 500. : 50.));
    BOOST_TEST(watch.finding() == "");
  }
}

BOOST_AUTO_TEST_CASE(a_section_between_no_tools_has_no_flow_stress)
{
  // Only sections with pressure on both faces are given one.
  IroningWatch watch;
  std::vector<SheetSection> free(2);
  watch.observe(free);
  watch.observe(free);
  BOOST_TEST(watch.suspicion() == "");
  watch.observe({});
  BOOST_TEST(watch.finding() == "");
}

BOOST_AUTO_TEST_SUITE_END()
