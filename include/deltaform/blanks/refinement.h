#pragma once

namespace deltaform
{
  class Section;

  /// When and where a blank is refined during a run; section Blank/Refinement. Every pass halves the marked cells once.
  struct RefinementSettings
  {
    RefinementSettings() = default;

    /// Of a solid.
    explicit RefinementSettings(Section section);

    bool active = false; ///< is anything refined at all? If not, nothing else is read
    bool by_error = false; ///< by the recovered stresses; if not, only edges in contact
    double share = 0; ///< of the estimated error (squared) that the marked cells hold
    double target = 0; ///< relative error in energy below which the error marks nothing
    unsigned every = 1; ///< increments between two refinements
    unsigned passes = 1; ///< at the same time
    unsigned levels = 0; ///< cells are halved at most so many times
    double edge_share = 0; ///< longest edge in contact over the tool's radius; 0: any
    bool rim = false; ///< refine at the rim of the contact zone
    bool smooth = false; ///< do the edges make up a smooth curve?
    bool from_the_start = false; ///< also before the first increment
    bool asked_for = true; ///< does the scene ask for it? Else results are those of a mesh that stays, and without
      ///< columns about it
  };
} // namespace deltaform
