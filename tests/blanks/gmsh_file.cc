// Meshes of Gmsh: those that are right are read as deal.II reads them, those that are wrong are refused in words.
#include "../../source/blanks/gmsh_file.h"
#include "../messages.h"

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <sstream>
#include <stdexcept>

using namespace deltaform;

namespace
{
  /// Two cells, 2 x 1; of the second the corners are clockwise. Node 9 belongs to none.
  const std::string format_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                               "$PhysicalNames\n3\n1 1 \"die side\"\n1 2 \"rim\"\n2 9 \"body\"\n$EndPhysicalNames\n"
                               "$Nodes\n7\n1 1 0 0\n2 2 0 0\n3 3 0 0\n9 7 7 0\n4 1 1 0\n5 2 1 0\n6 3 1 0\n$EndNodes\n"
                               "$Elements\n6\n1 15 2 0 1 1\n2 1 2 1 1 1 2\n3 1 2 1 1 2 3\n4 1 2 2 2 3 6\n"
                               "5 3 2 9 9 1 2 5 4\n6 3 2 9 9 2 5 6 3\n$EndElements\n";

  /// The left one of these in formats 4.0 and 4.1.
  const std::string format_40 =
    "$MeshFormat\n4 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 7 \"foot\"\n$EndPhysicalNames\n"
    "$Entities\n1 1 1 0\n1 0 0 0 0 0 0 0\n1 1 0 0 2 0 0 1 7 0\n1 1 0 0 2 1 0 0 1 1\n$EndEntities\n"
    "$Nodes\n2 4\n1 1 0 2\n1 1 0 0\n2 2 0 0\n1 2 0 2\n4 1 1 0\n5 2 1 0\n$EndNodes\n"
    "$Elements\n2 2\n1 1 1 1\n1 1 2\n1 2 3 1\n2 1 2 5 4\n$EndElements\n";
  const std::string format_41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 7 \"foot\"\n$EndPhysicalNames\n"
    "$Entities\n1 1 1 0\n1 0 0 0 0\n1 1 0 0 2 0 0 1 7 0\n1 1 0 0 2 1 0 0 1 1\n$EndEntities\n"
    "$Nodes\n2 4 1 5\n1 1 0 2\n1\n2\n1 0 0\n2 0 0\n2 1 0 2\n4\n5\n1 1 0\n2 1 0\n$EndNodes\n"
    "$Elements\n2 2 1 2\n1 1 1 1\n1 1 2\n2 1 3 1\n2 1 2 5 4\n$EndElements\n";

  /// The complaint about a file in which @p old is replaced.
  std::string complaint(const std::string &content, const std::string &old, const std::string &text)
  {
    const auto place = content.find(old);
    BOOST_REQUIRE(place != std::string::npos);
    std::string changed = content;
    changed.replace(place, old.size(), text);
    return message_of<std::invalid_argument>([&]() { const GmshFile file(changed); });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(gmsh_file)

BOOST_AUTO_TEST_CASE(as_deal_ii_reads_it)
{
  for (const std::string &content : {format_2, format_40, format_41})
  {
    dealii::Triangulation<2> expected, own;
    dealii::GridIn<2> reader(expected);
    std::istringstream stream(content);
    reader.read_msh(stream);
    const GmshFile file(content);
    own.create_triangulation(file.vertices, file.cells, file.boundary);
    BOOST_REQUIRE_EQUAL(own.n_active_cells(), expected.n_active_cells());
    auto other = expected.begin_active();
    for (const auto &cell : own.active_cell_iterators())
    {
      for (const auto v : cell->vertex_indices())
      {
        BOOST_TEST(cell->vertex_index(v) == other->vertex_index(v));
        BOOST_TEST((cell->vertex(v) == other->vertex(v)));
      }
      for (const auto f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          BOOST_TEST(cell->face(f)->boundary_id() == other->face(f)->boundary_id());
      ++other;
    }
  }
}

BOOST_AUTO_TEST_CASE(names_of_physical_curves)
{
  const GmshFile file(format_2);
  BOOST_TEST(file.names.size() == 2u);
  BOOST_TEST(file.names.at(1) == "die side");
  BOOST_TEST(file.names.at(2) == "rim");
  BOOST_TEST(GmshFile(format_41).names.at(7) == "foot");
  BOOST_TEST(GmshFile(format_40).boundary.boundary_lines.front().boundary_id == 7u);
}

BOOST_AUTO_TEST_CASE(counts_are_held_against_the_file)
{
  check_contains(complaint(format_2, "\n7\n", "\n2147483647\n"), {"line 11", "2147483647", "does not hold so many"});
  check_contains(complaint(format_2, "\n7\n", "\n6\n"), {"line 18", "$EndNodes"});
  check_contains(complaint(format_2, "\n7\n", "\n8\n"), {"line 19", "'$EndNodes'"});
  check_contains(complaint(format_2, "\n6\n1 15", "\n-1\n1 15"), {"-1 cannot be a number of elements"});
  check_contains(complaint(format_2, "$Elements\n6", "$Elements\n5"), {"$EndElements"});
  check_contains(complaint(format_2, "1 15 2 0", "1 15 99999 0"), {"99999 cannot be the number of tags"});
  check_contains(complaint(format_41, "2 1 0 2\n", "2 1 0 1\n"), {"4 nodes are announced, 3 are there"});
  check_contains(complaint(format_40, "1 2 3 1\n", "1 2 3 0\n"), {"2 elements are announced, 1 are there"});
}

BOOST_AUTO_TEST_CASE(files_end_and_begin)
{
  for (const std::string &content : {format_2, format_40, format_41})
    for (std::size_t n = 0; n + 2 < content.size(); ++n)
      BOOST_CHECK_THROW(GmshFile(content.substr(0, n)), std::invalid_argument);
  check_contains(complaint(format_2, "2.2 0", "2.2 1"), {"line 2", "binary"});
  check_contains(complaint(format_2, "2.2 0", "3.1 0"), {"format 3.1 is none of"});
  check_contains(complaint(format_2, "$EndPhysicalNames", "$End"), {"line 9", "'$End'"});
}

BOOST_AUTO_TEST_CASE(numbers_of_nodes)
{
  check_contains(complaint(format_2, "1 2 5 4", "1 2 8 4"), {"there is no node 8"});
  check_contains(complaint(format_2, "6 3 1 0", "5 3 1 0"), {"node 5 is there twice"});
  check_contains(complaint(format_2, "2 2 0 0", "2 nan 0 0"), {"'nan' cannot be a coordinate"});
  check_contains(complaint(format_2, "2 2 0 0", "2 1e300 0 0"), {"'1e300' cannot be a coordinate"});
  check_contains(complaint(format_2, "2 2 0 0", "2 x 0 0"), {"'x' is no number"});
}

BOOST_AUTO_TEST_CASE(cells_are_a_mesh)
{
  check_contains(complaint(format_2, "9 1 2 5 4", "9 1 2 2 4"), {"same node twice"});
  check_contains(complaint(format_2, "9 2 5 6 3", "9 1 2 5 4"), {"overlap"});
  check_contains(complaint(format_2, "2 5 6 3\n", "2 5 6\n"), {"'$EndElements'"});
  check_contains(complaint(format_2, "5 2 1 0", "5 2 -1 0"), {"no area"});
  check_contains(complaint(format_2, "4 1 2 2 2 3 6", "4 1 2 2 2 2 5"), {"lies inside of the mesh"});
  check_contains(complaint(format_2, "4 1 2 2 2 3 6", "4 1 2 2 2 1 6"), {"no edge of a quadrilateral"});
  check_contains(complaint(format_2, "4 1 2 2 2 3 6", "4 1 2 2 2 2 1"), {"two physical curves"});
  check_contains(complaint(format_2, "4 1 2 2 2 3 6", "4 2 2 2 2 3 6 5"), {"type 2", "recombine"});
}

BOOST_AUTO_TEST_SUITE_END()
