// What happens between the increments: stages begin, states are accepted.
#include <deltaform/model/model.h>
#include <deltaform/model/workspace.h>
#include <deltaform/parameters/scene_error.h>

#include <algorithm>

namespace deltaform
{
  std::vector<std::string> Model::begin_stage(const Stage &stage)
  {
    state_.released.reset(state_.unknowns.size(), actors_.tools.size(), actors_.supports.size(), actors_.loads.size());
    if (!state_.stage.empty())
      book_.release(stage.name, state_);
    state_.releases_at_once = state_.released.any && stage.release_at_once;
    enter_stage(stage);
    state_.time = stage.begin;
    auto lost = contact_.begin_stage(stage.begin, discretization_.numbering().size[0], state_.unknowns);
    supports_.hold(state_);
    formed_start_.enter(stage, book_);
    return lost;
  }


  void Model::start_from(const KeyedArrays &formed)
  {
    const unsigned int n_before = actors_.blank->n_dofs();
    const TakenOver taken = actors_.blank->take_formed(formed);
    for (const auto &load : actors_.loads)
      if (load->follows_path() && taken.unknowns.size() != n_before)
        throw SceneError("the earlier operation has refined the blank, and the nodes of a path stay the same: no arc "
                         "length with its mesh. Set Blank/Refinement/Largest bend = 0");
    contact_.resize();
    renumber();
    formed_start_.begin(taken);
  }


  void Model::enter_stage(const Stage &stage)
  {
    state_.stage = stage.name;
    state_.released.begin_stage(stage);
    contact_.enter_stage(stage);
    supports_.enter_stage(stage.name);
    std::vector<Term *> others;
    for (const auto &load : actors_.loads)
      if (load->acts_in(stage.name))
        others.push_back(load.get());
    stops_.enter_stage(stage.name);
    others.insert(others.end(), {&state_.released, &stops_});
    terms_.enter_stage(others);
  }


  void Model::commit(const Vector &q, const Workspace &workspace)
  {
    const Timers::Scope timer(timers_.all, timers_.commit);
    const double duration = workspace.time() - state_.time;
    const double landing = book_.work_of_landing(q, state_), surplus = landing > 0. ? energies().surplus() : 0.;
    state_.time = workspace.time();
    book_.accept(q, workspace.system(), state_);
    terms_.accept(q, state_.time, duration);
    state_.unknowns = q;
    state_.releases_at_once = false;
    // A tool that lands has fallen without a force; what it then does is what the blank and its contact take up.
    if (landing > 0.)
      state_.work.tools -= std::clamp(energies().surplus() - surplus, 0., landing);
  }

} // namespace deltaform
