#pragma once

#include <deltaform/assembly/types.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /**
   * The quadrilaterals of a solid blank with the names of the parts of their boundary. Meshes: a strip of given
   * thickness along a meridian, with the entries of the shell (flat: rectangle, block, disc; vertical: tube; curved:
   * segment of a ring or of a thick sphere), or a Gmsh file.
   */
  class SolidMesh
  {
  public:
    /// Read the entries of the section.
    SolidMesh(Section &section, unsigned int degree, bool axisymmetric);

    /// The cells; a strip lies in its parameter plane (arc length along the meridian, coordinate across), see place().
    const dealii::Triangulation<2> &triangulation() const
    {
      return *triangulation_;
    }

    dealii::Triangulation<2> &triangulation()
    {
      return *triangulation_;
    }

    /// Of all processes.
    unsigned int n_cells() const
    {
      return triangulation_->n_global_active_cells();
    }

    /// Level of the finest cells of the mesh as read.
    int first_level() const
    {
      return first_level_;
    }

    /// Where a node of the mesh as read lies in the undeformed body; refined cells divide that body.
    Point2 place(const Point2 &point) const;

    /// Names by boundary id.
    const std::vector<std::string> &boundaries() const
    {
      return boundaries_;
    }

    /// Is the body a strip, whose nodes lie in columns of equal first coordinate of the triangulation?
    bool is_strip() const
    {
      return !cross_sections_.empty();
    }

    /// Height of the strip, or of the box around the body.
    double thickness() const
    {
      return thickness_;
    }

  private:
    /// A place on the meridian: point, and where the top lies from it per unit of thickness.
    struct CrossSection
    {
      Point2 point;
      Tensor1 director;
    };

    void read_strip(Section &section, unsigned int degree, bool axisymmetric);
    void read_gmsh(Section &section);

    /// The triangulation from a file. @return the names of its physical curves, by their numbers
    std::map<unsigned int, std::string> read_cells(const Section &section, const std::string &name);
    void read_disc_segment(Section &section);

    /// Distributed among the processes if there are several: a process then sees its own cells and those next to them.
    std::unique_ptr<dealii::Triangulation<2>> triangulation_;
    std::vector<std::string> boundaries_;
    std::vector<CrossSection> cross_sections_;
    unsigned int cross_sections_per_cell_ = 1;
    double thickness_ = 0;
    int first_level_ = 0;
  };
} // namespace deltaform
