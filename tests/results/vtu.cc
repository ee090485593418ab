#include <deltaform/base/scene_error.h>
#include <deltaform/results/vtu.h>

#include "../base/messages.h"
#include "vtu_file.h"

#include <filesystem>

using namespace deltaform;

namespace
{
  /// Two unit squares side by side.
  Drawing two_squares()
  {
    Drawing drawing;
    drawing.points_per_cell = 4;
    drawing.points          = {{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1., 1.}, {2., 1.}};
    drawing.cells           = {0, 1, 4, 3, 1, 2, 5, 4};
    drawing.fields = {{"displacement", "length", true, 2, {.1, .2, 1.1, 1.2, 2.1, 2.2, 3.1, 3.2, 4.1, 4.2, 5.1, 5.2}},
                      {"equivalent_plastic_strain", "1", true, 1, {0., 1., 2., 3., 4., 5.}},
                      {"pressure", "stress", false, 1, {7., 8.}}};
    return drawing;
  }

  const Units units("in, tonf, tonf/in^2");

  /// The number of the drawing's point at the place of point @p i of the file.
  unsigned int point_at(const VtuFile &file, const unsigned int i)
  {
    return static_cast<unsigned int>(file.points.values[3 * i] + 3 * file.points.values[3 * i + 1]);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(vtu)

BOOST_AUTO_TEST_CASE(quadrilaterals_are_read_back)
{
  const TemporaryFolder folder;
  const auto path = folder.file("blank_0000.vtu");
  write_vtu(path, two_squares(), units);

  const VtuFile file(path);
  BOOST_TEST(file.n_cells == 2u);
  BOOST_TEST(file.n_points == 8u);
  BOOST_REQUIRE_EQUAL(file.points.values.size(), 24u);
  BOOST_TEST(file.cells.at("offsets").values == (std::vector<double>{4., 8.}), boost::test_tools::per_element());
  BOOST_TEST(file.cells.at("types").values == (std::vector<double>{9., 9.}), boost::test_tools::per_element());

  // Each cell goes round its square counterclockwise.
  const auto &connectivity = file.cells.at("connectivity").values;
  BOOST_REQUIRE_EQUAL(connectivity.size(), 8u);
  const std::vector<unsigned int> drawn{0, 1, 4, 3, 1, 2, 5, 4};
  for (unsigned int i = 0; i < 8; ++i)
    BOOST_TEST(point_at(file, static_cast<unsigned int>(connectivity[i])) == drawn[i]);
}

BOOST_AUTO_TEST_CASE(fields_have_units_values_and_real_vectors)
{
  const TemporaryFolder folder;
  const auto path    = folder.file("blank_0000.vtu");
  const auto drawing = two_squares();
  write_vtu(path, drawing, units);

  const VtuFile file(path);
  BOOST_REQUIRE_EQUAL(file.fields.size(), 3u);
  const auto &displacement = file.fields.at("displacement [in]");
  const auto &strain       = file.fields.at("equivalent_plastic_strain [-]");
  const auto &pressure     = file.fields.at("pressure [tonf/in^2]");
  BOOST_TEST(displacement.n_components == 3u);
  BOOST_REQUIRE_EQUAL(displacement.values.size(), 24u);
  for (unsigned int i = 0; i < 8; ++i)
  {
    const unsigned int point = point_at(file, i);
    for (unsigned int k = 0; k < 2; ++k)
      BOOST_TEST(displacement.values[3 * i + k] == drawing.fields[0].values[2 * point + k],
                 boost::test_tools::tolerance(1e-6));
    BOOST_TEST(displacement.values[3 * i + 2] == 0.);
    BOOST_TEST(strain.values[i] == double(point));
    BOOST_TEST(pressure.values[i] == (i < 4 ? 7. : 8.)); // constant over the cell
  }
}

BOOST_AUTO_TEST_CASE(lines_are_read_back)
{
  const TemporaryFolder folder;
  const auto path = folder.file("tools_0000.vtu");
  Drawing drawing;
  drawing.points_per_cell = 2;
  drawing.points          = {{0., 0.}, {1., 0.}, {2., 1.}};
  drawing.cells           = {0, 1, 1, 2};
  drawing.fields          = {{"tool", "index", false, 1, {0., 1.}}};
  write_vtu(path, drawing, units);

  const VtuFile file(path);
  BOOST_TEST(file.n_cells == 2u);
  BOOST_TEST(file.cells.at("types").values == (std::vector<double>{3., 3.}), boost::test_tools::per_element());
  BOOST_TEST(file.fields.at("tool [index]").values == (std::vector<double>{0., 0., 1., 1.}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(labels_cannot_break_the_file)
{
  const TemporaryFolder folder;
  const auto path = folder.file("blank_0000.vtu");
  write_vtu(path, two_squares(), Units("\"<in>\" & more, N, MPa"));
  const VtuFile file(path);
  BOOST_TEST(file.fields.count("displacement [\"<in>\" & more]") == 1u);
}

BOOST_AUTO_TEST_CASE(nothing_half_written_remains)
{
  const TemporaryFolder folder;
  write_vtu(folder.file("a.vtu"), two_squares(), units);
  BOOST_TEST(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 1);
  BOOST_CHECK_THROW(write_vtu("/nonexistent/a.vtu", two_squares(), units), SceneError);
}

BOOST_AUTO_TEST_SUITE_END()
