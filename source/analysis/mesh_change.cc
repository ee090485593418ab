#include <deltaform/analysis/mesh_change.h>
#include <deltaform/blanks/refinement.h>
#include <deltaform/parameters/text.h>

#include <utility>
#include <vector>

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


  MeshChange::MeshChange(State &state, Model &model, Workspace &workspace, Journal &journal)
    : state_(state), model_(model), workspace_(workspace), journal_(journal)
  {
    if (blank().goes_back())
      before_ = model_.state();
  }


  Adaptive &MeshChange::blank()
  {
    return *model_.actors().blank->adaptive();
  }


  void MeshChange::refine()
  {
    const unsigned int n_cells = blank().n_cells();
    const double energy = model_.blank().energy().elastic;
    std::vector<Vector> steps = state_.predictor.steps();
    model_.refine(steps);
    journal_.detail("mesh changed after increment " + std::to_string(state_.n_increments) + ": " +
                    change_in_words(n_cells, energy, model_));
    state_.predictor.renumber(std::move(steps));
  }


  void MeshChange::refine_unstressed(State &state, Model &model, Workspace &workspace, Journal &journal)
  {
    const Adaptive *blank = std::as_const(*model.actors().blank).adaptive();
    if (blank == nullptr || !blank->settings().from_the_start || model.committed().linfty_norm() > 0.)
      return;
    for (unsigned int pass = 0; pass < blank->settings().passes && model.mark(); ++pass)
      MeshChange(state, model, workspace, journal).refine();
    workspace.follow_mesh();
  }


  bool MeshChange::go_back(const Stage &stage, const Rejected &why)
  {
    if (!blank().goes_back())
      return false;
    model_.set_state(before_, stage);
    workspace_.begin(model_.time());
    state_.predictor.restart();
    blank().leave_marked();
    journal_.detail("no equilibrium with it: " + why.sentence + ". Back to " + std::to_string(blank().n_cells()) +
                    " cells");
    return true;
  }
} // namespace deltaform
