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
    };

    /// Read the entries of the section (Points, Fillet radii, Elements, Grading). @param element_bytes that an element,
    /// with all that is built on it, takes at least: asked for before the elements are placed
    ShellMesh(Section &section, unsigned int degree, double element_bytes);

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
    void mesh_piece(const MeridianPiece &piece,
                    unsigned int n_cells,
                    const TimeFunction &grading,
                    double total_length,
                    unsigned int degree);

    std::vector<Point2> nodes_;
    std::vector<Cell> cells_;
    std::vector<double> arc_length_;
  };
} // namespace deltaform
