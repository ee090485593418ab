#pragma once

#include <deltaform/increment/pace.h>
#include <deltaform/increment/predictor.h>
#include <deltaform/increment/set_limit.h>
#include <deltaform/increment/step_control.h>
#include <deltaform/model/model_state.h>
#include <deltaform/parameters/skipped_time.h>

#include <iosfwd>
#include <optional>
#include <string>

namespace deltaform
{
  /**
   * The state of a run after an accepted increment: a value. It can be copied and kept, saved and loaded, and an
   * analysis goes on from it, as often as one likes. Cells of a solid are not joined again: no
   * analysis goes back over their refinement.
   */
  struct State
  {
    ModelState model;
    unsigned int stage = 0; ///< index of the one that it belongs to
    unsigned int n_increments = 0; ///< accepted so far
    unsigned int n_iterations = 0; ///< of Newton's method so far
    unsigned int since_refinement = 0; ///< increments

    /// @name Memory of the last increments
    ///@{
    Predictor predictor; ///< of the next one
    std::optional<StepControl::State> step; ///< after the last increment of the stage, if there is one
    Pace pace; ///< of the stage
    SetLimit set_limit; ///< of searches
    ///@}

    std::string conditions; ///< what conditions remember, in bytes that only they understand
    std::string ends; ///< the same of what may end the stage
    SkippedTime skipped; ///< by stages that ended before their time

    double time() const
    {
      return model.time;
    }

    void save(std::ostream &stream) const;
    void load(std::istream &stream);
  };
} // namespace deltaform
