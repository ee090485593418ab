#include <deltaform/io/vtu.h>
#include <deltaform/parameters/scene_error.h>

#include "../messages.h"
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
    drawing.points = {{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1., 1.}, {2., 1.}};
    drawing.cells = {0, 1, 4, 3, 1, 2, 5, 4};
    drawing.fields = {{"displacement", "length", true, 2, {.1, .2, 1.1, 1.2, 2.1, 2.2, 3.1, 3.2, 4.1, 4.2, 5.1, 5.2}},
                      {"equivalent_plastic_strain", "1", true, 1, {0., 1., 2., 3., 4., 5.}},
                      {"pressure", "stress", false, 1, {7., 8.}}};
    return drawing;
  }

  const Units units("in, tonf, tonf/in^2");
} // namespace

BOOST_AUTO_TEST_SUITE(vtu)

BOOST_AUTO_TEST_CASE(quadrilaterals_are_read_back)
{
  const TemporaryFolder folder;
  const auto path = folder.file("blank_0000.vtu");
  write_vtu(path, two_squares(), units);

  const VtuFile file(path);
  BOOST_TEST(file.n_cells == 2u);
  BOOST_TEST(file.n_points == 6u); // cells share points
  BOOST_TEST(file.points.values ==
               (std::vector<double>{0., 0., 0., 1., 0., 0., 2., 0., 0., 0., 1., 0., 1., 1., 0., 2., 1., 0.}),
             boost::test_tools::per_element());
  BOOST_TEST(file.cells.at("offsets").values == (std::vector<double>{4., 8.}), boost::test_tools::per_element());
  BOOST_TEST(file.cells.at("types").values == (std::vector<double>{9., 9.}), boost::test_tools::per_element());

  // Each cell goes round its square counterclockwise.
  BOOST_TEST(file.cells.at("connectivity").values == (std::vector<double>{0., 1., 4., 3., 1., 2., 5., 4.}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(fields_have_units_values_and_real_vectors)
{
  const TemporaryFolder folder;
  const auto path = folder.file("blank_0000.vtu");
  const auto drawing = two_squares();
  write_vtu(path, drawing, units);

  const VtuFile file(path);
  BOOST_REQUIRE_EQUAL(file.fields.size(), 2u);
  BOOST_REQUIRE_EQUAL(file.cell_fields.size(), 1u);
  const auto &displacement = file.fields.at("displacement [in]");
  const auto &strain = file.fields.at("equivalent_plastic_strain [-]");
  const auto &pressure = file.cell_fields.at("pressure [tonf/in^2]");
  BOOST_TEST(displacement.n_components == 3u);
  BOOST_REQUIRE_EQUAL(displacement.values.size(), 18u);
  for (unsigned int i = 0; i < 6; ++i)
  {
    for (unsigned int k = 0; k < 2; ++k)
      BOOST_TEST(displacement.values[3 * i + k] == drawing.fields[0].values[2 * i + k],
                 boost::test_tools::tolerance(1e-6));
    BOOST_TEST(displacement.values[3 * i + 2] == 0.);
  }
  BOOST_TEST(strain.values == drawing.fields[1].values, boost::test_tools::per_element());
  BOOST_TEST(pressure.values == drawing.fields[2].values, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(tensors_have_six_named_components)
{
  const TemporaryFolder folder;
  const auto path = folder.file("blank_0000.vtu");
  Drawing drawing = two_squares();
  drawing.fields.push_back({"plastic_strain", "1", false, 4, {1., 2., 3., 4., 5., 6., 7., 8.}});
  write_vtu(path, drawing, units);

  // VTK's order of a symmetric tensor: XX YY ZZ XY YZ XZ.
  const auto tensor = VtuFile(path).cell_fields.at("plastic_strain [-]");
  BOOST_TEST(tensor.values == (std::vector<double>{1., 2., 3., 4., 0., 0., 5., 6., 7., 8., 0., 0.}),
             boost::test_tools::per_element());
  BOOST_TEST(tensor.component_names == (std::vector<std::string>{"rr", "zz", "hoop", "rz", "z hoop", "r hoop"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(lines_are_read_back)
{
  const TemporaryFolder folder;
  const auto path = folder.file("tools_0000.vtu");
  Drawing drawing;
  drawing.points_per_cell = 2;
  drawing.points = {{0., 0.}, {1., 0.}, {2., 1.}};
  drawing.cells = {0, 1, 1, 2};
  drawing.fields = {{"tool", "index", false, 1, {0., 1.}}};
  write_vtu(path, drawing, units);

  const VtuFile file(path);
  BOOST_TEST(file.n_cells == 2u);
  BOOST_TEST(file.cells.at("types").values == (std::vector<double>{3., 3.}), boost::test_tools::per_element());
  BOOST_TEST(file.cell_fields.at("tool [index]").values == (std::vector<double>{0., 1.}),
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
