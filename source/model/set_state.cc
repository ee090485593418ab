// The committed state of a model as a value, and going to one.
#include <deltaform/model/model.h>
#include <deltaform/parameters/scene_error.h>

namespace deltaform
{
  namespace
  {
    [[noreturn]] void refuse(const ModelState &saved, const std::size_t n_here)
    {
      throw SceneError("Cannot resume: the saved state has " + std::to_string(saved.unknowns.size()) +
                       " unknowns, the scene has " + std::to_string(n_here) + ".");
    }
  } // namespace


  ModelState Model::state() const
  {
    ModelState result = state_;
    result.body = actors_.blank->state();
    result.interfaces = contact_.save();
    return result;
  }


  void Model::set_state(const ModelState &state, const Stage &stage)
  {
    const std::size_t n_before = state_.unknowns.size();
    const std::size_t n = state.unknowns.size(), n_tools = actors_.tools.size();
    for (const Vector *const forces : {&state.hold, &state.load_forces, &state.reactions})
      if (forces->size() != n)
        refuse(state, n_before);
    if (state.tool_forces.size() != n_tools || state.travels.size() != n_tools ||
        state.load_resultants.size() != actors_.loads.size())
      refuse(state, n_before);
    // Before anything changes, as far as it can be known.
    if (state.interfaces.size() != actors_.interfaces.size() ||
        (actors_.blank->adaptive() == nullptr && state.unknowns.size() != n_before))
      refuse(state, n_before);
    actors_.blank->set_state(state.body);
    if (state.unknowns.size() != n_before)
    {
      contact_.resize();
      renumber();
    }
    if (state.unknowns.size() != state_.unknowns.size())
      refuse(state, state_.unknowns.size());
    state_ = state;
    state_.body = KeyedArrays();
    state_.interfaces.clear();
    contact_.load(state.interfaces);
    enter_stage(stage);
    discard(state_.time);
  }
} // namespace deltaform
