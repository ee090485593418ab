#pragma once

#include <deltaform/analysis/state.h>
#include <deltaform/increment/increment.h>
#include <deltaform/model/model.h>
#include <deltaform/model/workspace.h>
#include <deltaform/process/journal.h>

namespace deltaform
{
  /// A refinement of the blank, and the way back where no equilibrium is found with it.
  class MeshChange
  {
  public:
    /// @p state of the run, which @p model has accepted
    MeshChange(State &state, Model &model, Workspace &workspace, Journal &journal);

    /// Refine what is marked.
    void refine();

    /// Refine what is marked before the first increment, where a blank without stress needs no new equilibrium.
    static void refine_unstressed(State &state, Model &model, Workspace &workspace, Journal &journal);

    /// The state before, with what was marked left alone. @param why there is no equilibrium @return can the blank go
    /// back?
    bool go_back(const Stage &stage, const Rejected &why);

  private:
    Adaptive &blank();

    State &state_;
    Model &model_;
    Workspace &workspace_;
    Journal &journal_;
    ModelState before_; ///< empty if the blank cannot go back
  };
} // namespace deltaform
