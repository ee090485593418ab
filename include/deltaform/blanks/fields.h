#pragma once

#include <deltaform/assembly/types.h>
#include <deltaform/blanks/sheet_section.h>
#include <deltaform/io/drawing.h>
#include <deltaform/io/table.h>

#include <limits>
#include <string>
#include <vector>

namespace deltaform
{
  /// A criterion of a scene (Limits/Criteria) where it is largest.
  struct LargestCriterion
  {
    std::string name; ///< "rice-tracey"
    std::string column; ///< "rice_tracey"
    std::string unit; ///< dimension
    double value;
    Point2 place; ///< in the undeformed blank (length)
  };

  /// Where a sheet bends most within one element, or from one element of a solid to the next.
  struct SharpestBend
  {
    double angle = 0; ///< rad
    double place = 0; ///< R0 of the middle of the element (length)
    double length = std::numeric_limits<double>::infinity(); ///< of the element of a shell, over the thickness
  };

  /// Where a sheet carries most transverse shear.
  struct LargestShear
  {
    double share = 0; ///< mean of the shear stress over the thickness, over that of the flow stress
    double place = 0; ///< R0 (length)
  };

  /// Cells of a solid that are turned inside out at a corner.
  struct FoldedCells
  {
    double share = 0; ///< of the area of the section
    Point2 place; ///< middle of the largest of them in the undeformed blank (length)
  };

  /// How the metal flows in the last increment.
  struct MeshError
  {
    double work = 0; ///< plastic (force*length)
    double error = 0; ///< estimated, of that work, as the mesh is too coarse
  };

  /// Where a sheet lies within itself.
  struct Overlap
  {
    double share = 0; ///< of the thickness; 0: nowhere
    double first = 0, second = 0; ///< R0 of both parts (length)
  };

  /// Where a face of the blank is innermost, beyond the line r = 0 if r < 0.
  struct InnermostPlace
  {
    double r = std::numeric_limits<double>::infinity(); ///< length
    unsigned int node = 0;
    double place = 0; ///< R0 of the node (length)
  };

  /// What can be seen of the accepted state of a blank: tables, pictures, measures.
  class Fields
  {
  public:
    virtual ~Fields() = default;

    /// Values along the blank, one row per node.
    virtual Table profile(const Vector &q) const = 0;

    /// Picture for ParaView; @p nodal are further values, one per entry of Blank::positions() (shell: spread over the
    /// thickness).
    virtual Drawing draw(const Vector &q, const std::vector<DrawnField> &nodal) const = 0;

    virtual double smallest_thickness() const = 0;

    /// The criteria of the scene, each where it is largest. All processes together.
    virtual std::vector<LargestCriterion> largest_criteria() const = 0;

    /// Is it a sheet, with cross-sections?
    virtual bool is_sheet() const
    {
      return false;
    }

    /// Cross-sections at the nodes; empty if the blank is no sheet (a solid carries its necks itself).
    virtual std::vector<SheetSection> sections() const
    {
      return {};
    }

    /// None of solids.
    virtual Overlap overlap(const Vector & /*q*/) const
    {
      return {};
    }

    /// None of a solid, a membrane, an elastic sheet.
    virtual LargestShear largest_shear(const Vector & /*q*/) const
    {
      return {};
    }

    /// Of the nodes that began off the line r = 0; those of a sheet further than its thickness, as its faces may cross
    /// where it begins with a slope.
    virtual InnermostPlace innermost_place(const Vector &q) const = 0;

    /// None of a sheet.
    virtual FoldedCells folded_cells(const Vector & /*q*/) const
    {
      return {};
    }

    /// Of solids that are no sheets: the bends of these are seen by sharpest_bend(). None of an increment that was not
    /// accepted in this run on this mesh.
    virtual MeshError mesh_error(const Vector & /*q*/) const
    {
      return {};
    }

    /// Shell: between the nodes of an element of degree 1; of degree 2, between its middle and an end. Solid: the turn
    /// of the middle line of a strip that is ten thicknesses long or more. No angle of other solids and membranes.
    virtual SharpestBend sharpest_bend(const Vector & /*q*/) const
    {
      return {};
    }
  };
} // namespace deltaform
