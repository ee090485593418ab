#pragma once
// The part of a system's tangent that does not change; private to the files that implement System.
#include <deltaform/solver/system.h>

#include "low_rank_update.h"

namespace deltaform
{
  /**
   * The tangent is kept in storage of its own, so that the solver's matrix may stay that of the constant part. What a
   * pass adds to it is noted and taken back exactly by the next one.
   */
  struct System::Constant
  {
    Constant(std::vector<DofIndex> candidates, const std::size_t largest_rank)
      : update(std::move(candidates), largest_rank)
    {
    }

    /// An entry is about to get @p value more.
    void note(const System &system, DofIndex row, DofIndex column, double value);

    /// An entry of the stored matrix as it was before something was added to it.
    struct Before
    {
      double *place;
      double value;
    };

    bool kept = false; ///< the constant part is in the matrix
    bool complete = false; ///< and has got its share of the residual in this pass
    bool condensed = false; ///< the last factorize() meant the update, not the whole
    bool prepared = false; ///< the solver holds the constant part
    std::vector<double> storage;
    std::vector<Before> before;
    Vector diagonal; ///< of distributed rows, of the constant part
    std::vector<UpdateEntry> entries;
    std::vector<DofIndex> bordered; ///< unknowns that the border couples with
    std::vector<Vector> motions; ///< that cost no energy
    std::vector<bool> prescribed; ///< when the solver was prepared
    std::vector<bool> isolated; ///< candidates without entries in the constant part
    LowRankUpdate update;
  };
} // namespace deltaform
