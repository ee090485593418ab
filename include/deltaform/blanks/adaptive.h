#pragma once

#include <deltaform/assembly/point_origin.h>
#include <deltaform/assembly/side.h>
#include <deltaform/assembly/types.h>

#include <array>
#include <vector>

namespace deltaform
{
  struct RefinementSettings;

  /// A blank whose mesh is refined between increments.
  class Adaptive
  {
  public:
    virtual ~Adaptive() = default;

    /// When to refine.
    virtual const RefinementSettings &settings() const = 0;

    /// Of the contact edges of both sides, accepted, if they are known; longer where edges may become longer, so that
    /// tools say how long they may be (EdgeWishes).
    virtual std::vector<double> edge_lengths() const
    {
      return {};
    }

    /// Mark what is to be refined in the accepted state: by the settings, and every contact edge of a side that is
    /// longer than @p longest_edges (undeformed). @return is anything marked?
    virtual bool mark(const std::array<std::vector<double>, 2> &longest_edges) = 0;

    /// Refine what is marked. @p fields are values of the unknowns: in, on the old mesh; out, on the new one. The first
    /// is the accepted state, the others are steps that lead to it.
    virtual void refine(std::vector<Vector> &fields) = 0;

    /// Can it go back to a state before a refinement?
    virtual bool goes_back() const
    {
      return false;
    }

    /// It went back, as no equilibrium was found with what was refined last: leave that alone for the time being.
    virtual void leave_marked()
    {
    }

    /// Relative error in energy as estimated by the last mark(); NaN if it was not.
    virtual double estimated_error() const = 0;

    /// Of all processes.
    virtual unsigned int n_cells() const = 0;

    /// Of every contact point after refine().
    virtual const std::vector<PointOrigin> &point_origins(Side side) const = 0;
  };
} // namespace deltaform
