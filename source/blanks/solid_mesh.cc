#include "solid_mesh.h"
#include "gmsh_file.h"
#include "shell_mesh.h"

#include <deltaform/geometry/grading.h>
#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/memory.h>
#include <deltaform/process/ranks.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// A cell with its unknowns, points and share of the factors takes at least this; 15 000 cells of degree 1 took
    /// 12 kB each.
    constexpr double cell_bytes = 10000.;

    /// Coordinates of the nodes across, in [-1/2, 1/2]: equal shares of the integral of 1/size.
    /// @throws std::invalid_argument where the grading cannot be used
    std::vector<double> levels(const TimeFunction &grading, const unsigned int n)
    {
      const auto size = [&grading](const double t) {
        const double result = grading(t);
        if (!(result >= 1e-6 && result <= 1e6))
          throw std::invalid_argument("must lie between 1e-6 and 1e6 on [0, 1]; it is " + text::format(result) +
                                      " at t = " + text::format(t));
        return result;
      };
      std::vector<double> result(n + 1, .5);
      for (unsigned int k = 0; k < n; ++k)
        result[k] = static_cast<double>(k) / n - .5;
      if (grading.is_constant())
        return result;
      for (const double end : {0., 1.}) // the quadrature does not look at them
        size(end);
      const std::vector<double> ends = element_ends(size, 0., 1., n);
      std::transform(ends.begin(), ends.end(), result.begin(), [](const double t) { return t - .5; });
      return result;
    }

    /// What a scene says of a strip besides its middle line.
    struct StripEntries
    {
      StripEntries(Section &section, const unsigned int degree)
        : thickness(
            section.number("Thickness", required(1.), Range::positive(), "length", "Initial thickness of the blank.")),
          n_across(section.integer("Elements through thickness",
                                   degree == 1 ? 4 : 2,
                                   1,
                                   100000,
                                   "Number of elements from bottom to top (strip).")),
          grading(section.function("Grading through thickness",
                                   Default<std::string>("1"),
                                   "1",
                                   "Relative size of the elements as a function of t = 0 at the bottom to 1 at the "
                                   "top; expression or table.")),
          variation(section.function("Thickness variation",
                                     Default<std::string>("1"),
                                     "1",
                                     "Thickness relative to the entry Thickness as a function of t = arc length / "
                                     "length of the meridian; expression or table."))
      {
        try
        {
          across = levels(grading, n_across);
        }
        catch (const std::invalid_argument &error)
        {
          section.fail("Grading through thickness", error.what());
        }
        const std::string reference = section.choice("Points lie on the",
                                                     "middle",
                                                     {"middle", "bottom", "top"},
                                                     "Which line of the strip Points and Fillet radii describe.");
        offset = reference == "middle" ? 0. : (reference == "bottom" ? .5 : -.5);
      }

      double thickness; ///< initial (length)
      unsigned int n_across; ///< cells from bottom to top
      TimeFunction grading, variation;
      std::vector<double> across; ///< see levels()
      double offset; ///< of the middle from the line that is described, in thicknesses
    };


    /// Cells in columns: the parameter plane of a strip. @p across: coordinates of their corners from bottom to top
    void make_columns(const unsigned int n, const std::vector<double> &across, dealii::Triangulation<2> &triangulation)
    {
      std::vector<Point2> vertices;
      for (unsigned int c = 0; c <= n; ++c)
        for (const double level : across)
          vertices.emplace_back(c, level);
      std::vector<dealii::CellData<2>> cells;
      const unsigned int column = across.size();
      for (unsigned int c = 0; c < n; ++c)
        for (unsigned int l = 0; l + 1 < column; ++l)
        {
          dealii::CellData<2> data;
          const unsigned int corner = c * column + l;
          data.vertices = {corner, corner + column, corner + 1, corner + column + 1};
          cells.push_back(data);
        }
      triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
      for (const auto &cell : triangulation.active_cell_iterators())
        for (unsigned int f = 0; f < 4; ++f)
          if (cell->face(f)->at_boundary())
            cell->face(f)->set_boundary_id(f == 2 ? 0 : (f == 3 ? 1 : (f == 0 ? 2 : 3)));
    }


    /// The stiffness of a cell across and along differ by the square of the ratio of its edges: the digits of a double
    /// are soon used up.
    void require_aspect(const Section &section, const std::string &entry, const double one, const double other)
    {
      const double longest = std::max(one, other), shortest = std::min(one, other);
      if (!(longest <= ceilings::cell_aspect * shortest))
        section.fail(entry, "there is a cell with edges of " + text::rounded(longest) + " and " +
                              text::rounded(shortest) + "; the ratio may be at most " +
                              text::format(ceilings::cell_aspect));
    }


    std::unique_ptr<dealii::Triangulation<2>> make_triangulation()
    {
      // Refinement leaves cells at a vertex that differ by one level at most, as p4est does: the mesh is that of
      // several processes.
      if (ranks::count() == 1)
        return std::make_unique<dealii::Triangulation<2>>(dealii::Triangulation<2>::limit_level_difference_at_vertices);
      return std::make_unique<dealii::parallel::distributed::Triangulation<2>>(ranks::communicator());
    }
  } // namespace


  SolidMesh::SolidMesh(Section &section, const unsigned int degree, const bool axisymmetric)
    : triangulation_(make_triangulation())
  {
    const std::string kind = section.choice(
      "Mesh",
      "strip",
      {"strip", "disc segment", "gmsh"},
      "Strip: Points, Fillet radii, Elements and Grading describe its middle line as for a shell, Thickness "
      "its height; its boundaries are bottom, top, start and end. Disc segment: the lower quarter of a disc or ball "
      "about the axis; boundaries arc, axis and equator. Gmsh: a file of quadrilaterals.");
    if (kind == "gmsh")
      read_gmsh(section);
    else if (kind == "disc segment")
      read_disc_segment(section);
    else
      read_strip(section, degree, axisymmetric);
    first_level_ = static_cast<int>(triangulation_->n_global_levels()) - 1;
  }


  void SolidMesh::read_strip(Section &section, const unsigned int degree, const bool axisymmetric)
  {
    const StripEntries strip(section, degree);
    thickness_ = strip.thickness;
    const ShellMesh line(section, degree, strip.n_across * cell_bytes * degree * degree);
    const double length = line.arc_length().back();
    const auto height = [&](const unsigned int node) {
      const double result = strip.variation(line.arc_length()[node] / length);
      if (!(result >= 1e-6 && result <= 1e6))
        section.fail("Thickness variation", "must lie between 1e-6 and 1e6 on [0, 1]");
      return result;
    };

    // At a kink, and where the meridian meets the axis at an angle, the director halves the angle (a mitre).
    cross_sections_per_cell_ = degree;
    const unsigned int n = line.cells().size();
    for (unsigned int c = 0; c <= n; ++c)
    {
      const auto &cell = line.cells()[std::min(c, n - 1)];
      const Point2 point = line.nodes()[cell.nodes[c < n ? 0 : 1]];
      const double own = cell.angle[c < n ? 0 : 1];
      // Not if the meridian runs along the axis.
      const bool on_axis = axisymmetric && std::abs(point[0]) < 1e-12 * thickness_ && std::abs(std::cos(own)) > 1e-6;
      const double before = c == n ? own : (c > 0 ? line.cells()[c - 1].angle[1] : (on_axis ? -own : own));
      const double after = c == n && on_axis ? 2 * std::acos(-1.) - own : own;
      const double half_turn = .5 * (after - before), angle = .5 * (after + before);
      const Tensor1 direction =
        height(cell.nodes[c < n ? 0 : 1]) / std::cos(half_turn) * Tensor1({-std::sin(angle), std::cos(angle)});
      cross_sections_.push_back({point + strip.offset * thickness_ * direction, direction});
      if (degree == 2 && c < n)
      {
        const Tensor1 middle = height(cell.nodes[2]) * Tensor1({-std::sin(cell.angle[2]), std::cos(cell.angle[2])});
        cross_sections_.push_back({line.nodes()[cell.nodes[2]] + strip.offset * thickness_ * middle, middle});
      }
    }
    for (unsigned int c = 0; c < n; ++c)
      for (unsigned int l = 0; l < strip.n_across; ++l)
      {
        const auto &[begin, direction] = cross_sections_[c * degree];
        require_aspect(section, "Thickness", begin.distance(cross_sections_[(c + 1) * degree].point),
                       thickness_ * direction.norm() * (strip.across[l + 1] - strip.across[l]));
      }
    make_columns(n, strip.across, *triangulation_);
    boundaries_ = {"bottom", "top", "start", "end"};
  }


  std::map<unsigned int, std::string> SolidMesh::read_cells(const Section &section, const std::string &name)
  {
    std::error_code error;
    const auto size = std::filesystem::file_size(name, error);
    if (error) // also of what is no file: a pipe may never end
      section.fail("File", "cannot read '" + name + "': " + error.message());
    std::ifstream file(name, std::ios::binary);
    if (!file)
      section.fail("File", "cannot read '" + name + "': " + std::strerror(errno));
    if (size > ceilings::mesh_bytes)
      section.fail("File", "'" + name + "' has more than " + std::to_string(ceilings::mesh_bytes >> 20) + " MB");
    std::string why;
    try
    {
      GmshFile mesh({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
      memory::require(section, "File", static_cast<double>(mesh.cells.size()), "cells", cell_bytes);
      triangulation_->create_triangulation(mesh.vertices, mesh.cells, mesh.boundary);
      return std::move(mesh.names);
    }
    catch (const std::invalid_argument &problem)
    {
      why = problem.what();
    }
    catch (const dealii::ExceptionBase &problem)
    {
      std::ostringstream text;
      problem.print_info(text);
      why = text.str();
    }
    section.fail("File", "'" + name + "' is no mesh of quadrilaterals that can be read: " + why);
  }


  void SolidMesh::read_gmsh(Section &section)
  {
    const std::string name =
      section.text("File",
                   Default<std::string>("blank.msh"),
                   "File of the mesh, format 2 or 4 (Gmsh). Its physical curves name the boundaries.");
    if (section.documentation())
      return;
    const std::map<unsigned int, std::string> names = read_cells(section, name);
    for (const auto &cell : triangulation_->active_cell_iterators())
    {
      const auto lengths = [&cell](const unsigned int f) { return cell->face(f)->measure(); };
      const auto [shortest, longest] = std::minmax({lengths(0), lengths(1), lengths(2), lengths(3)});
      require_aspect(section, "File", longest, shortest);
    }
    double low = 1e300, high = -1e300;
    for (const auto &vertex : triangulation_->get_vertices())
    {
      low = std::min(low, vertex[1]);
      high = std::max(high, vertex[1]);
    }
    thickness_ = section.number("Thickness",
                                Default<double>(high - low),
                                Range::positive(),
                                "length",
                                "A height, for expressions; by default that of the box around the body.");
    std::map<dealii::types::boundary_id, unsigned int> index;
    for (const auto &cell : triangulation_->active_cell_iterators())
      for (unsigned int f = 0; f < 4; ++f)
        if (cell->face(f)->at_boundary())
        {
          const auto id = cell->face(f)->boundary_id();
          if (index.count(id) == 0)
          {
            index[id] = boundaries_.size();
            boundaries_.push_back(names.count(id) > 0 ? names.at(id)
                                  : id == 0           ? "rest"
                                                      : "boundary " + std::to_string(id));
          }
          cell->face(f)->set_boundary_id(index[id]);
        }
  }


  void SolidMesh::read_disc_segment(Section &section)
  {
    const double radius =
      section.number("Radius", required(1.), Range::positive(), "length", "Radius of the disc segment.");
    const double height = section.number("Centre z",
                                         Default<double>(0.),
                                         Range::any(),
                                         "length",
                                         "Height of the centre of the disc segment, on the axis.");
    const int refinements = section.integer("Refinements", 3, 0, 10, "Each halves the cells of the disc segment.");
    memory::require(section, "Refinements", 3. * std::pow(4., refinements), "cells", cell_bytes);
    thickness_ = radius;
    dealii::GridGenerator::quarter_hyper_ball(*triangulation_, Point2(), radius);
    dealii::GridTools::rotate(-.5 * std::acos(-1.), *triangulation_);
    dealii::GridTools::shift(Tensor1({0., height}), *triangulation_);
    triangulation_->set_manifold(0, dealii::SphericalManifold<2>(Point2(0., height)));
    boundaries_ = {"arc", "axis", "equator"};
    for (const auto &cell : triangulation_->active_cell_iterators())
      for (unsigned int f = 0; f < 4; ++f)
        if (cell->face(f)->at_boundary())
        {
          const Point2 middle = cell->face(f)->center();
          cell->face(f)->set_boundary_id(std::abs(middle[0]) < 1e-9 * radius            ? 1
                                         : std::abs(middle[1] - height) < 1e-9 * radius ? 2
                                                                                        : 0);
        }
    triangulation_->refine_global(refinements);
    for (const auto &cell : triangulation_->active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        if (std::abs(cell->vertex(v)[0]) < 1e-9 * radius)
          cell->vertex(v)[0] = 0.;
  }


  Point2 SolidMesh::place(const Point2 &point) const
  {
    if (!is_strip())
      return point;
    const auto i = static_cast<unsigned int>(std::lround(point[0] * cross_sections_per_cell_));
    return cross_sections_[i].point + thickness_ * point[1] * cross_sections_[i].director;
  }
} // namespace deltaform
