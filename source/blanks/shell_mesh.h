#pragma once

#include <deltaform/assembly/types.h>
#include <deltaform/geometry/meridian.h>
#include <deltaform/parameters/time_function.h>

#include <array>
#include <vector>

namespace deltaform
{
  class Section;

  /**
   * Nodes and elements along the meridian of a shell: every straight or curved piece gets a whole number of elements,
   * so that kinks lie at nodes; inside a piece the sizes follow the grading.
   */
  class ShellMesh
  {
  public:
    struct Cell
    {
      std::array<unsigned int, 3> nodes{
        {invalid_index, invalid_index, invalid_index}}; ///< start, end, middle (degree 2)
      std::array<double, 3> angle{}; ///< of the exact tangent at the nodes, per cell because of kinks
      unsigned int piece = 0; ///< of the meridian on which it lies
    };

    /// Of a cell, from one share of its arc length to another.
    struct Part
    {
      unsigned int cell;
      double begin, end;

      bool whole() const
      {
        return begin == 0. && end == 1.;
      }

      bool operator==(const Part &other) const
      {
        return cell == other.cell && begin == other.begin && end == other.end;
      }
    };

    /// Read the entries of the section (Points, Fillet radii, Elements, Grading). @param element_bytes that an element,
    /// with all that is built on it, takes at least: asked for before the elements are placed
    ShellMesh(Section &section, unsigned int degree, double element_bytes);

    /// Another mesh of the same meridian: @p parts of the cells of this one, in order. Whole cells stay as they are.
    ShellMesh divided(const std::vector<Part> &parts) const;

    const std::vector<Point2> &nodes() const
    {
      return nodes_;
    }

    const std::vector<Cell> &cells() const
    {
      return cells_;
    }

    /// Arc length of every node from the start of the meridian.
    const std::vector<double> &arc_length() const
    {
      return arc_length_;
    }

  private:
    ShellMesh() = default;

    /// A place of a cell: a node, or between nodes.
    struct Place
    {
      Point2 point;
      double arc_length, angle;
    };

    void mesh_piece(unsigned int piece,
                    unsigned int n_cells,
                    const TimeFunction &grading,
                    double total_length,
                    unsigned int degree);
    Place place(const Cell &cell, double share) const;
    unsigned int add_node(const Place &place);

    std::vector<MeridianPiece> pieces_;
    std::vector<Point2> nodes_;
    std::vector<Cell> cells_;
    std::vector<double> arc_length_;
  };
} // namespace deltaform
