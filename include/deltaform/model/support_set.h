#pragma once

#include <deltaform/model/model_state.h>
#include <deltaform/model/numbering.h>
#include <deltaform/stage/actors.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// The supports of a run as one part of the equations: which unknowns are prescribed in the present stage, their
  /// values, and the forces that this takes.
  class SupportSet
  {
  public:
    SupportSet(Actors &actors, const Numbering &numbering);

    /// Supports of this stage act from here on. Also after the unknowns were numbered anew.
    void enter_stage(const std::string &stage);

    /// The blank was refined: its unknowns have new numbers.
    void renumber();

    /// Symmetry, supports, and border unknowns of tools and loads that are absent.
    const std::vector<bool> &is_prescribed() const
    {
      return is_prescribed_;
    }

    /// Unknowns with the values that are prescribed at @p time; all else as it is in @p state.
    Vector prescribed(const ModelState &state, double time) const;

    /// A stage begins: supports with Hold keep what is reached in @p state.
    void hold(ModelState &state) const;

    /// Sum of the forces (moments) of a support on the blank; of one that ended, what is left of it.
    double reaction(unsigned int support, const ModelState &state) const;

    /// The same without unknowns that are already @p counted, which is brought up to date.
    double uncounted_reaction(unsigned int support, const ModelState &state, std::vector<bool> &counted) const;

  private:
    Actors &actors_;
    const Numbering &numbering_;
    std::string stage_;
    std::vector<bool> is_prescribed_;
  };
} // namespace deltaform
