// Files of rows of numbers, as spreadsheets and people write them.
#include <deltaform/io/point_file.h>

#include <boost/test/unit_test.hpp>

#include <cstdio>
#include <fstream>
#include <stdexcept>

using namespace deltaform;
using Rows = std::vector<std::vector<double>>;

namespace
{
  Rows rows_of(const std::string &content, const unsigned int columns)
  {
    const std::string name = "rows.csv";
    std::ofstream(name) << content;
    struct Remove
    {
      const char *name;
      ~Remove()
      {
        std::remove(name);
      }
    } remove{name.c_str()};
    return read_rows(name, columns);
  }

  void refused(const std::string &content, const std::string &words)
  {
    BOOST_CHECK_EXCEPTION(rows_of(content, 2), std::invalid_argument, [&](const std::invalid_argument &error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).find(words) != std::string::npos;
    });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(point_file)

BOOST_AUTO_TEST_CASE(names_comments_commas_and_blanks)
{
  const Rows expected = {{1., -2.5}, {3e-3, 4.}};
  BOOST_TEST((rows_of("# from the lab\nstrain,stress\n1,-2.5\n\n3e-3, 4 # the last one\n", 2) == expected));
  BOOST_TEST((rows_of("\xef\xbb\xbf"
                      "1\t-2.5\r\n0.003 4",
                      2) == expected));
  BOOST_TEST(rows_of("# nothing\n", 2).empty());
}

BOOST_AUTO_TEST_CASE(what_is_no_row_is_named_by_its_line)
{
  refused("a,b\n1,2\n3\n", "line 3: '3' is no row of 2 numbers");
  refused("1,2\n# a comment\n3,4,5\n", "line 3");
  refused("1,2\nx,4\n", "line 2: 'x 4'");
  refused("l,2\n3,4\n", "line 1: 'l 2'"); // a digit that was misread is no name
  refused("1,2\na,b\n", "line 2"); // names stand in the first line
  refused("1,2\n3,nan\n", "line 2");
  refused("1,2\n3,1e300\n", "line 2");
  refused("1 2\n3;4\n", "line 2: '3;4'");
}

BOOST_AUTO_TEST_CASE(what_is_no_file)
{
  BOOST_CHECK_THROW(read_rows("there_is_none.csv", 2), std::invalid_argument);
  BOOST_CHECK_THROW(read_rows(".", 2), std::invalid_argument);
  BOOST_CHECK_THROW(read_rows("/dev/null", 2), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
