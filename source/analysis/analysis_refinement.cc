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
    const RefinementSettings *settings = actors_.blank->refinement();
    return settings != nullptr && since_refinement_ >= settings->every && problem_.mark();
  }


  bool Analysis::refine()
  {
    Checkpoint unrefined = checkpoint();
    const unsigned int passes = actors_.blank->refinement()->passes;
    bool marked = true;
    for (unsigned int pass = 1; marked; ++pass)
    {
      const unsigned int n_cells = actors_.blank->n_cells();
      const double energy = actors_.blank->energy().elastic;
      problem_.refine();
      journal_.detail("refined after increment " + std::to_string(n_increments_) + ": " + std::to_string(n_cells) +
                      " cells to " + std::to_string(actors_.blank->n_cells()) + ", " +
                      std::to_string(problem_.committed().size()) + " unknowns, elastic energy " +
                      text::format(energy) + " to " + text::format(actors_.blank->energy().elastic));
      // No extrapolation over a change of the mesh.
      before_ = problem_.committed();
      last_increment_ = 0.;
      const IncrementResult result = attempt(time_, Effort::last_resorts);
      if (result.rejected)
      {
        problem_.discard(time_);
        return stop("after a refinement of the blank there is no equilibrium: " + result.rejected->sentence +
                      ". Refine less at once (Blank/Refinement), or begin with a finer mesh",
                    status_of(*result.rejected), std::move(unrefined));
      }
      before_ = problem_.committed();
      problem_.commit(result.q);
      ++n_increments_;
      marked = pass < passes && problem_.mark();
      if (!marked)
        since_refinement_ = 0;
      AcceptedIncrement increment = accepted(result.cost);
      increment.is_last_here = !marked;
      notify(increment);
    }
    return true;
  }
} // namespace deltaform
