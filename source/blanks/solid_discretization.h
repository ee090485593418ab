#pragma once

#include "solid_boundary.h"
#include "solid_points.h"
#include "solid_space.h"


namespace deltaform
{
  class Section;

  /// A solid cut into cells: nodes and unknowns, quadrature points, boundary. They follow the mesh together.
  class SolidDiscretization
  {
  public:
    /// Read the mesh; set_up() has to follow. @p moves: following pressures know the deformed body
    SolidDiscretization(Section &section, const unsigned int degree, const bool axisymmetric, const bool moves)
      : space_(section, degree, axisymmetric), points_(space_), boundary_(space_, points_, moves)
    {
    }

    /// Number and measure the cells as they are now. @p places: where the nodes of the undeformed body are; empty:
    /// where the mesh as read says.
    void set_up(const SolidSpace::CellPlaces &places = {});

    /// @throws SceneError if cells lie at r < 0 or are turned inside out
    void check(const Section &section) const;

    const SolidSpace &space() const
    {
      return space_;
    }
    SolidSpace &space()
    {
      return space_;
    }

    const SolidPoints &points() const
    {
      return points_;
    }

    const SolidBoundary &boundary() const
    {
      return boundary_;
    }

  private:
    SolidSpace space_;
    SolidPoints points_;
    SolidBoundary boundary_;
  };
} // namespace deltaform
