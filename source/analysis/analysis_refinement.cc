// Another mesh, and the equilibrium after it.
#include <deltaform/analysis/analysis.h>
#include <deltaform/blanks/refinement.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <utility>

namespace deltaform
{
  namespace
  {
    /// @param n_cells, energy before
    std::string change_in_words(const unsigned int n_cells, const double energy, const Model &model)
    {
      return std::to_string(n_cells) + " cells to " + std::to_string(model.blank().adaptive()->n_cells()) + ", " +
             std::to_string(model.committed().size()) + " unknowns, elastic energy " + text::format(energy) + " to " +
             text::format(model.blank().energy().elastic);
    }
  } // namespace


  bool Analysis::refinement_marked()
  {
    const Adaptive *blank = std::as_const(*actors_.blank).adaptive();
    return blank != nullptr && state_.since_refinement >= blank->settings().every && model_.mark();
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
      model_.refine();
      journal_.detail("refined after increment " + std::to_string(state_.n_increments) + ": " +
                      change_in_words(n_cells, energy, model_));
      // No extrapolation over a change of the mesh.
      state_.before = model_.committed();
      state_.last_length = 0.;
      const IncrementResult result = attempt(time(), Effort::last_resorts);
      if (result.rejected)
      {
        workspace_.begin(time());
        return stop("after a refinement of the blank there is no equilibrium: " + result.rejected->sentence +
                      ". Refine less at once (Blank/Refinement), or begin with a finer mesh",
                    status_of(*result.rejected), std::move(unrefined));
      }
      state_.before = model_.committed();
      model_.commit(result.q, workspace_);
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
