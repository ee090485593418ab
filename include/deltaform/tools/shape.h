#pragma once

#include <deltaform/geometry/curve.h>

#include <vector>

namespace deltaform
{
  /// The profile of a rigid tool in its own frame, as the entries of a scene describe it.
  class Shape : public Curve
  {
  public:
    virtual ~Shape() = default;

    /// Are the points of the profile given in the scene's frame (no mirror image if the tool touches the blank's top)?
    virtual bool in_scene_frame() const
    {
      return false;
    }

    /// The blank is one of plane strain, in which r = 0 is a line like any other and no axis. Called once, before the
    /// first projection. A shape that the user gives point by point leaves out the mirror image then, unless it is
    /// asked for.
    virtual void set_plane_strain()
    {
    }

    /// Radius of the hole through which a blank that ends inside it would fall; 0: none.
    virtual double opening() const
    {
      return 0.;
    }

  protected:
    /// Where an entry of a shape has this value, its line goes on for ever.
    static constexpr double endless_radius = 1e30;

    /// See the constructors of Curve.
    void build(const std::vector<Point2> &points,
               const std::vector<double> &radii,
               End start = End::free,
               End end = End::free)
    {
      Curve::operator=(Curve(points, radii, start, end));
    }

    void build_closed(const std::vector<Point2> &points, const std::vector<double> &radii)
    {
      Curve::operator=(Curve::closed(points, radii));
    }
  };
} // namespace deltaform
