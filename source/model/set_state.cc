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

    /// Before anything changes, as far as it can be known.
    void check(const ModelState &state, const Actors &actors, const std::size_t n_before)
    {
      const std::size_t n = state.unknowns.size(), n_tools = actors.tools.size();
      bool fits = state.tool_forces.size() == n_tools && state.travels.size() == n_tools &&
                  state.load_resultants.size() == actors.loads.size() &&
                  state.load_histories.size() == actors.loads.size() &&
                  state.interfaces.size() == actors.interfaces.size() &&
                  (actors.blank->adaptive() != nullptr || n == n_before);
      for (unsigned int i = 0; fits && i < actors.loads.size(); ++i)
        fits = state.load_histories[i].size() == actors.loads[i]->history().size();
      for (const Vector *const forces : {&state.hold, &state.load_forces, &state.reactions})
        fits = fits && forces->size() == n;
      if (!fits)
        refuse(state, n_before);
    }
  } // namespace


  ModelState Model::state() const
  {
    ModelState result = state_;
    result.body = body_.state();
    result.interfaces = contact_.save();
    book_.save_histories(result);
    return result;
  }


  void Model::set_state(const ModelState &state, const Stage &stage)
  {
    check(state, actors_, state_.unknowns.size());
    body_.set_state(state.body);
    if (state.unknowns.size() != state_.unknowns.size())
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
    book_.load_histories(state);
    enter_stage(stage);
  }
} // namespace deltaform
