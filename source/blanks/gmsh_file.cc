#include "gmsh_file.h"
#include "gmsh_words.h"

#include <deltaform/parameters/text.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace deltaform
{
  namespace
  {
    constexpr long long largest = std::numeric_limits<int>::max();

    using Cell = dealii::CellData<2>;

    /// The corners of a cell, one after the other around it.
    std::array<unsigned int, 4> around(const Cell &cell)
    {
      return {{cell.vertices[0], cell.vertices[1], cell.vertices[3], cell.vertices[2]}};
    }

    /// By the formula of Gauss; negative if the corners are clockwise.
    double area(const std::vector<Point2> &vertices, const Cell &cell)
    {
      const Tensor1 a = vertices[cell.vertices[3]] - vertices[cell.vertices[0]],
                    b = vertices[cell.vertices[2]] - vertices[cell.vertices[1]];
      return .5 * (a[0] * b[1] - a[1] * b[0]);
    }

    std::string place(const Point2 &x)
    {
      return "r = " + text::rounded(x[0]) + ", z = " + text::rounded(x[1]);
    }
  } // namespace


  GmshFile::GmshFile(const std::string &content)
  {
    GmshWords words(content);
    read_format(words);
    while (!words.at_end())
    {
      const std::string section = words.word();
      if (section.size() < 2 || section[0] != '$')
        words.fail("a section '$...' should begin, not '" + text::printable(section.substr(0, 40)) + "'");
      if (section == "$PhysicalNames")
        read_names(words);
      else if (section == "$Entities")
        read_entities(words);
      else if (section == "$Nodes")
        read_nodes(words);
      else if (section == "$Elements")
        read_elements(words);
      else
        words.skip_to("$End" + section.substr(1));
    }
    if (!has_elements_)
      words.fail("there are no $Elements");
    if (cells.empty())
      words.fail("there is no quadrilateral among the elements. Let Gmsh recombine the triangles");
    check_cells();
    check_edges();
    dealii::GridTools::delete_unused_vertices(vertices, cells, boundary);
    dealii::GridTools::consistently_order_cells(cells);
  }


  void GmshFile::read_format(GmshWords &words)
  {
    if (words.at_end())
      words.fail("the file is empty");
    words.expect("$MeshFormat");
    const double version = words.coordinate();
    const long tenfold = std::lround(10. * std::clamp(version, 0., 100.));
    if (!(tenfold >= 20 && tenfold <= 22) && tenfold != 40 && tenfold != 41)
      words.fail("format " + text::format(version) + " is none of 2.0 to 2.2, 4.0, 4.1");
    format_ = static_cast<unsigned int>(tenfold);
    if (words.integer("kind of file", 0, 1) != 0)
      words.fail("the file is binary: save it as ASCII");
    words.integer("size of numbers", 1, 16);
    words.expect("$EndMeshFormat");
  }


  void GmshFile::read_names(GmshWords &words)
  {
    const Number n = words.count("number of physical names", 6);
    for (Number i = 0; i < n; ++i)
    {
      const Number dimension = words.integer("dimension", 0, 3), tag = words.integer("number of a group", 0, largest);
      const std::string quoted = words.rest_of_line();
      const auto from = quoted.find('"'), to = quoted.rfind('"');
      if (from == std::string::npos || from == to)
        words.fail("the name of a physical group is missing");
      if (dimension == 1)
        names[static_cast<unsigned int>(tag)] = quoted.substr(from + 1, to - from - 1);
    }
    words.expect("$EndPhysicalNames");
  }


  void GmshFile::read_entities(GmshWords &words)
  {
    if (format_ < 40)
      words.fail("$Entities belong to format 4");
    std::array<Number, 4> n = {};
    for (auto &count : n)
      count = words.count("number of entities", 4);
    for (unsigned int dimension = 0; dimension < 4; ++dimension)
      for (Number i = 0; i < n[dimension]; ++i)
      {
        const Number tag = words.integer("number of an entity", -largest, largest);
        for (unsigned int k = 0; k < (dimension == 0 && format_ == 41 ? 3 : 6); ++k)
          words.coordinate();
        const Number n_groups = words.count("number of groups", 2);
        // Of several, the last one; a curve that is run through backwards has a negative number.
        for (Number k = 0; k < n_groups; ++k)
          groups_[dimension][tag] =
            static_cast<unsigned int>(std::abs(words.integer("number of a group", -largest, largest)));
        if (dimension > 0)
          words.skip(words.count("number of bounding entities", 2));
      }
    words.expect("$EndEntities");
  }


  void GmshFile::read_nodes(GmshWords &words)
  {
    if (std::exchange(has_nodes_, true))
      words.fail("there are $Nodes twice");
    const Number n_blocks = format_ < 40 ? 1 : words.count("number of blocks", 4);
    const Number n_nodes = words.count("number of nodes", 8);
    if (format_ == 41)
      words.skip(2);
    vertices.reserve(static_cast<std::size_t>(n_nodes));
    const auto add = [&](const Number tag) {
      if (!numbers_.emplace(tag, static_cast<unsigned int>(vertices.size())).second)
        words.fail("node " + std::to_string(tag) + " is there twice");
      const double r = words.coordinate(), z = words.coordinate();
      words.coordinate();
      vertices.emplace_back(r, z);
    };
    for (Number block = 0; block < n_blocks; ++block)
    {
      Number n = n_nodes, parameters = 0;
      if (format_ >= 40)
      {
        const Number first = words.integer("dimension or entity", -largest, largest),
                     second = words.integer("dimension or entity", -largest, largest);
        const bool parametric = words.integer("flag", 0, 1) == 1;
        parameters = parametric ? std::clamp<Number>(format_ == 41 ? first : second, 0, 3) : 0;
        n = words.count("number of nodes", 8);
      }
      std::vector<Number> tags;
      for (Number i = 0; i < n && format_ == 41; ++i)
        tags.push_back(words.integer("number of a node", 0, largest));
      for (Number i = 0; i < n; ++i)
      {
        add(format_ == 41 ? tags[static_cast<std::size_t>(i)] : words.integer("number of a node", 0, largest));
        words.skip(parameters);
      }
    }
    if (static_cast<Number>(vertices.size()) != n_nodes)
      words.fail(std::to_string(n_nodes) + " nodes are announced, " + std::to_string(vertices.size()) + " are there");
    words.expect("$EndNodes");
  }


  void GmshFile::read_elements(GmshWords &words)
  {
    if (!has_nodes_)
      words.fail("$Elements stand before $Nodes");
    if (std::exchange(has_elements_, true))
      words.fail("there are $Elements twice");
    const Number n_blocks = format_ < 40 ? 1 : words.count("number of blocks", 4);
    const Number n_elements = words.count("number of elements", 4);
    if (format_ == 41)
      words.skip(2);
    Number total = 0;
    for (Number block = 0; block < n_blocks; ++block)
    {
      Number n = n_elements, type = 0;
      unsigned int physical = 0;
      if (format_ >= 40)
      {
        const Number first = words.integer("dimension or entity", -largest, largest),
                     second = words.integer("dimension or entity", -largest, largest);
        physical = format_ == 41 ? group_of(first, second) : group_of(second, first);
        type = words.integer("type of an element", 1, 1000);
        n = words.count("number of elements", 4);
      }
      for (Number i = 0; i < n; ++i, ++total)
      {
        words.integer("number of an element", 0, largest);
        if (format_ < 40)
        {
          type = words.integer("type of an element", 1, 1000);
          const Number n_tags = words.count("number of tags", 2);
          physical =
            n_tags > 0 ? static_cast<unsigned int>(std::abs(words.integer("number of a group", -largest, largest))) : 0;
          words.skip(n_tags - 1);
        }
        read_element(words, type, physical);
      }
    }
    if (total != n_elements)
      words.fail(std::to_string(n_elements) + " elements are announced, " + std::to_string(total) + " are there");
    words.expect("$EndElements");
  }


  void GmshFile::read_element(GmshWords &words, const Number type, const unsigned int physical)
  {
    constexpr Number line = 1, quadrilateral = 3, point = 15;
    const auto next = [&]() { return vertex(words, words.integer("number of a node", 0, largest)); };
    if (type == point)
      next();
    else if (type == line)
    {
      dealii::CellData<1> data;
      data.vertices = {next(), next()};
      data.boundary_id = physical;
      boundary.boundary_lines.push_back(data);
    }
    else if (type == quadrilateral)
    {
      Cell cell;
      for (unsigned int i = 0; i < 4; ++i)
        cell.vertices[dealii::GeometryInfo<2>::ucd_to_deal[i]] = next();
      cell.material_id = physical;
      cells.push_back(cell);
    }
    else
      words.fail("an element of type " + std::to_string(type) +
                 " is none of points, lines and quadrilaterals of first order. Let Gmsh recombine triangles");
  }


  unsigned int GmshFile::group_of(const Number dimension, const Number tag) const
  {
    if (dimension < 0 || dimension > 3)
      return 0;
    const auto &groups = groups_[static_cast<std::size_t>(dimension)];
    const auto found = groups.find(tag);
    return found == groups.end() ? 0 : found->second;
  }


  unsigned int GmshFile::vertex(GmshWords &words, const Number tag) const
  {
    const auto found = numbers_.find(tag);
    if (found == numbers_.end())
      words.fail("there is no node " + std::to_string(tag));
    return found->second;
  }


  void GmshFile::check_cells()
  {
    for (auto &cell : cells)
    {
      const auto corners = around(cell);
      double diagonal = 0.;
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int k = 0; k < i; ++k)
        {
          if (corners[i] == corners[k])
            throw std::invalid_argument("a quadrilateral has the same node twice, at " + place(vertices[corners[i]]));
          diagonal = std::max(diagonal, (vertices[corners[i]] - vertices[corners[k]]).norm_square());
        }
      const double own = area(vertices, cell);
      if (!(std::abs(own) > 1e-12 * diagonal))
        throw std::invalid_argument("a quadrilateral has no area, at " + place(vertices[corners[0]]));
    }
    dealii::GridTools::invert_cells_with_negative_measure(vertices, cells);
  }


  void GmshFile::check_edges()
  {
    // Run through counterclockwise, an edge inside has one cell on each side.
    std::map<std::pair<unsigned int, unsigned int>, bool> edges;
    for (const auto &cell : cells)
    {
      const auto corners = around(cell);
      for (unsigned int i = 0; i < 4; ++i)
        if (!edges.emplace(std::make_pair(corners[i], corners[(i + 1) % 4]), true).second)
          throw std::invalid_argument("quadrilaterals overlap, or three have one edge, at " +
                                      place(vertices[corners[i]]));
    }
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> groups;
    auto &lines = boundary.boundary_lines;
    const auto is_twice = [&](const dealii::CellData<1> &line) {
      const unsigned int a = line.vertices[0], b = line.vertices[1];
      const bool one = edges.count({a, b}) > 0, other = edges.count({b, a}) > 0;
      if (one == other)
        throw std::invalid_argument("a line from " + place(vertices[a]) + " to " + place(vertices[b]) +
                                    (one ? " lies inside of the mesh: a physical curve must be a part of the boundary"
                                         : " is no edge of a quadrilateral"));
      const auto [group, is_new] = groups.emplace(std::minmax(a, b), line.boundary_id);
      if (!is_new && group->second != line.boundary_id)
        throw std::invalid_argument("a line from " + place(vertices[a]) + " to " + place(vertices[b]) +
                                    " belongs to two physical curves");
      return !is_new;
    };
    lines.erase(std::remove_if(lines.begin(), lines.end(), is_twice), lines.end());
  }
} // namespace deltaform
