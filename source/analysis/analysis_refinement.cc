// Another mesh, and the equilibrium after it.
#include <deltaform/analysis/analysis.h>
#include <deltaform/analysis/mesh_change.h>
#include <deltaform/blanks/refinement.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/reports/accepted_increment.h>

#include <utility>

namespace deltaform
{
  bool Analysis::refinement_marked()
  {
    const Adaptive *blank = std::as_const(*actors_.blank).adaptive();
    return blank != nullptr && state_.since_refinement >= blank->settings().every && model_.mark();
  }


  bool Analysis::refine()
  {
    Checkpoint unrefined = checkpoint();
    const unsigned int passes = actors_.blank->adaptive()->settings().passes;
    bool marked = true;
    for (unsigned int pass = 1; marked; ++pass)
    {
      MeshChange change(state_, model_, workspace_, journal_);
      change.refine();
      const IncrementResult result = attempt(time(), Effort::last_resorts);
      if (!result.rejected)
        model_.commit(result.q, workspace_);
      else if (!change.go_back(stage(), *result.rejected))
      {
        workspace_.begin(time());
        return stop("after a refinement of the blank there is no equilibrium: " + result.rejected->sentence +
                      ". Refine less at once (Blank/Refinement), or begin with a finer mesh",
                    status_of(*result.rejected), std::move(unrefined));
      }
      ++state_.n_increments;
      marked = pass < passes && model_.mark();
      if (!marked)
        state_.since_refinement = 0;
      AcceptedIncrement increment = accepted(result.cost);
      increment.is_last_here = !marked;
      increment.strain_at_rest = result.strain_at_rest;
      conditions_.observe(increment);
      notify(increment);
    }
    return true;
  }


  void Analysis::regain_equilibrium()
  {
    const IncrementResult result = attempt(time(), Effort::last_resorts);
    cost_ += result.cost;
    if (!result.rejected)
      model_.commit(result.q, workspace_);
    journal_.note(model_.formed_start().end(result.rejected ? result.rejected->sentence : ""));
  }
} // namespace deltaform
