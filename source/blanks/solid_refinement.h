#pragma once

#include "solid_discretization.h"
#include "solid_surface.h"
#include "solid_transfer.h"

#include <deltaform/blanks/adaptive.h>
#include <deltaform/blanks/refinement.h>
#include <deltaform/io/keyed_arrays.h>

#include <array>
#include <limits>
#include <vector>

namespace deltaform
{
  /// Refining a solid during the run: which cells, and that all that hangs on them follows (doc/theory/solid.md).
  class SolidRefinement : public Adaptive
  {
  public:
    SolidRefinement(const RefinementSettings &settings,
                    SolidDiscretization &body,
                    SolidSurface &surface,
                    const MaterialPoints &material,
                    SolidTransfer &transfer)
      : settings_(settings), body_(body), surface_(surface), material_(material), transfer_(transfer)
    {
    }

    const RefinementSettings &settings() const override
    {
      return settings_;
    }
    bool mark(const std::array<std::vector<double>, 2> &longest_edges) override;
    void refine(std::vector<Vector> &fields) override;
    double estimated_error() const override;
    unsigned int n_cells() const override;
    const std::vector<PointOrigin> &point_origins(Side side) const override;

    /// An increment was accepted.
    void update(const Vector &q);

    /// Undeformed places of the nodes of the mesh as read; of none if nothing is refined.
    const std::vector<Point2> &first_places() const
    {
      return first_places_;
    }

    /// Does a state have refinements?
    static bool has_passes(const KeyedArrays &state);

    /// Put the refinements so far into a state, or refine as it was there. @throws SceneError if there were fewer
    void put(KeyedArrays &state) const;
    void take(const KeyedArrays &state);

  private:
    /// Own cells with the largest errors, by the settings.
    std::vector<bool> marked_by_error();

    /// Estimated squared errors of all processes' cells above which a cell is refined.
    double error_threshold(const std::vector<double> &squares) const;

    /// Are the points of the children of a cell, at the committed displacements, not turned inside out? The points of
    /// the cell itself may all be right where a corner of it is folded.
    bool divisible(unsigned int cell) const;

    /// Flag the @p marked cells that can be divided, and with them what their neighbours need. @return whether any is
    bool flag_divisible(std::vector<bool> &marked);

    /// Take the flags off cells that would have to follow a finer neighbour and cannot, and off those that this leaves
    /// too coarse. One process. @return did any lose it?
    bool withdraw_flags(std::vector<bool> &marked);

    RefinementSettings settings_;
    SolidDiscretization &body_;
    SolidSurface &surface_;
    const MaterialPoints &material_;
    SolidTransfer &transfer_;
    std::vector<std::vector<bool>> passes_; ///< which cells were refined, pass by pass
    std::array<std::vector<PointOrigin>, 2> point_origins_;
    double estimated_error_ = std::numeric_limits<double>::quiet_NaN();
    std::vector<Point2> first_places_;
    std::vector<Point2> places_; ///< of the nodes, accepted; of none if nothing is refined
  };
} // namespace deltaform
