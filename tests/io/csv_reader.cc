// What CsvWriter writes is read back.
#include <deltaform/io/csv_reader.h>

#include <boost/test/unit_test.hpp>

#include <sstream>

using namespace deltaform;
using Cells = std::vector<std::string>;

BOOST_AUTO_TEST_SUITE(csv_reader)

BOOST_AUTO_TEST_CASE(comments_names_and_rows)
{
  std::istringstream stream("# a title, with a comma\n# units\nincrement,stage,force\n1,press,2.5\n2,\"a, b\",nan\n");
  CsvReader reader(stream);
  BOOST_TEST((reader.names() == Cells{"increment", "stage", "force"}));
  BOOST_TEST((reader.next() == Cells{"1", "press", "2.5"}));
  BOOST_TEST((reader.next() == Cells{"2", "a, b", "nan"}));
  BOOST_TEST(!reader.next().has_value());
}

BOOST_AUTO_TEST_CASE(quotes_within_quotes_and_empty_cells)
{
  std::istringstream stream("x,y,z\n\"say \"\"go\"\"\",,\n");
  CsvReader reader(stream);
  BOOST_TEST((reader.next() == Cells{"say \"go\"", "", ""}));
}

BOOST_AUTO_TEST_CASE(a_line_without_its_end_is_none)
{
  std::istringstream cut("x,y\n1,2\n3,4");
  CsvReader reader(cut);
  BOOST_TEST(reader.next().has_value());
  BOOST_TEST(!reader.next().has_value());
  std::istringstream nothing("# only comments\n");
  BOOST_TEST(CsvReader(nothing).names().empty());
}

BOOST_AUTO_TEST_SUITE_END()
