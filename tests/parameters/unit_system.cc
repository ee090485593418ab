#include <deltaform/parameters/unit_system.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(unit_system)

BOOST_AUTO_TEST_CASE(stresses_in_pascals)
{
  BOOST_TEST(*UnitSystem("mm, N, MPa").stress == 1e6);
  BOOST_TEST(*UnitSystem("m, N, Pa, s").stress == 1.);
  BOOST_TEST(*UnitSystem("mm, N, N/mm^2").stress == 1e6, boost::test_tools::tolerance(1e-14));
  // 1 psi = 6894.757 Pa and 1 long ton-force per square inch = 15.4443 MPa (NIST SP 811, B.8).
  BOOST_TEST(*UnitSystem("in, lbf, psi").stress == 6894.757, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(*UnitSystem("in, tonf, tonf/in^2").stress == 15.4443e6, boost::test_tools::tolerance(1e-5));
  for (const auto *const label : {"consistent", "", "mm, N", "mm, N, bananas", "mm, N, N/mm", "mm, N, /"})
    BOOST_TEST(!UnitSystem(label).stress.has_value(), label);
}

BOOST_AUTO_TEST_CASE(units_that_do_not_go_together)
{
  for (const auto *const label : {"mm, N, MPa", "m, N, Pa", "m, MN, MPa", "mm, kN, GPa", "in, kip, ksi",
                                  "in, tonf, tonf/in^2", "consistent", "mm, N, bananas"})
    BOOST_TEST(UnitSystem(label).objection() == "");
  BOOST_TEST(UnitSystem("mm, N, Pa").objection().find("1000000 Pa") != std::string::npos);
  BOOST_TEST(UnitSystem("m, N, MPa").objection().find("1e-6 MPa") != std::string::npos);
  BOOST_TEST(UnitSystem("mm, kN, MPa").objection().find("1000 MPa") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(units_in_other_letters)
{
  BOOST_TEST(UnitSystem("mm, N, Mpa").misspelt() == "'Mpa' is not known; 'MPa' is");
  BOOST_TEST(UnitSystem("mm, n, MPa").misspelt() == "'n' is not known; 'N' is");
  for (const auto *const label : {"mm, N, MPa", "consistent", "mm, N, bananas", "in, tonf, tonf/in^2", ""})
    BOOST_TEST(UnitSystem(label).misspelt() == "", label);
}

BOOST_AUTO_TEST_SUITE_END()
