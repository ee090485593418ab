// Refinement between two increments, and the equilibrium after it.
#include <deltaform/base/text.h>
#include <deltaform/blanks/refinement.h>
#include <deltaform/scene/simulation.h>

namespace deltaform
{
  bool Simulation::refinement_marked()
  {
    const RefinementSettings *settings = scene_.actors.blank->refinement();
    return settings != nullptr && since_refinement_ >= settings->every && problem_.mark();
  }


  std::string Simulation::refine(const Stage &stage)
  {
    const unsigned int passes = scene_.actors.blank->refinement()->passes;
    bool marked = true;
    for (unsigned int pass = 1; marked; ++pass)
    {
      const unsigned int n_cells = scene_.actors.blank->n_cells();
      const double energy = scene_.actors.blank->energy().elastic;
      problem_.refine();
      journal_.detail("refined after increment " + std::to_string(increment_) + ": " + std::to_string(n_cells) +
                      " cells to " + std::to_string(scene_.actors.blank->n_cells()) + ", " +
                      std::to_string(problem_.committed().size()) + " unknowns, elastic energy " +
                      text::format(energy) + " to " + text::format(scene_.actors.blank->energy().elastic));
      // No extrapolation over a change of the mesh.
      before_ = problem_.committed();
      last_increment_ = 0.;
      Vector q;
      NewtonResult result;
      const std::string failure = attempt(time_, Effort::damped, q, result);
      total_iterations_ += result.iterations;
      if (!failure.empty())
        return failure;
      before_ = problem_.committed();
      problem_.commit(q);
      ++increment_;
      IncrementCost cost;
      cost.iterations = result.iterations;
      cost.rounds = result.rounds;
      cost.correction_iterations = result.correction_iterations;
      marked = pass < passes && problem_.mark();
      recorder_.record(problem_, stage, time_, increment_, cost, !marked);
      accepted_iterations_ = total_iterations_;
    }
    since_refinement_ = 0;
    return "";
  }
} // namespace deltaform
