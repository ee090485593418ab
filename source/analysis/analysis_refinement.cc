// Refinement between two increments, and the equilibrium after it.
#include <deltaform/analysis/analysis.h>
#include <deltaform/base/command_line.h>
#include <deltaform/base/text.h>
#include <deltaform/blanks/refinement.h>
#include <deltaform/model/accepted_increment.h>

#include <utility>

namespace deltaform
{
  bool Analysis::refinement_marked()
  {
    const Adaptive *blank = std::as_const(*actors_.blank).adaptive();
    return blank != nullptr && state_.since_refinement >= blank->settings().every && problem_.mark();
  }


  bool Analysis::refine()
  {
    Checkpoint unrefined = checkpoint();
    const Adaptive &blank = *actors_.blank->adaptive();
    const unsigned int passes = blank.settings().passes;
    bool marked = true;
    for (unsigned int pass = 1; marked; ++pass)
    {
      const unsigned int n_cells = blank.n_cells();
      const double energy = actors_.blank->energy().elastic;
      problem_.refine();
      journal_.detail("refined after increment " + std::to_string(state_.n_increments) + ": " +
                      std::to_string(n_cells) + " cells to " + std::to_string(blank.n_cells()) + ", " +
                      std::to_string(problem_.committed().size()) + " unknowns, elastic energy " +
                      text::format(energy) + " to " + text::format(actors_.blank->energy().elastic));
      // No extrapolation over a change of the mesh.
      state_.before = problem_.committed();
      state_.last_length = 0.;
      const IncrementResult result = attempt(time(), Effort::last_resorts);
      if (result.rejected)
      {
        problem_.discard(time());
        return stop("after a refinement of the blank there is no equilibrium: " + result.rejected->sentence +
                      ". Refine less at once (Blank/Refinement), or begin with a finer mesh",
                    status_of(*result.rejected), std::move(unrefined));
      }
      state_.before = problem_.committed();
      problem_.commit(result.q);
      ++state_.n_increments;
      marked = pass < passes && problem_.mark();
      if (!marked)
        state_.since_refinement = 0;
      AcceptedIncrement increment = accepted(result.cost);
      increment.is_last_here = !marked;
      increment.strain_at_rest = result.strain_at_rest;
      for (const auto &condition : conditions_)
        condition->observe(increment);
      notify(increment);
    }
    return true;
  }
} // namespace deltaform
