// A finer mesh between two increments: all that hangs on the unknowns follows.
#include "collector.h"

#include <deltaform/blanks/refinement.h>
#include <deltaform/model/model.h>


namespace deltaform
{
  bool Model::mark()
  {
    Adaptive *blank = actors_.blank->adaptive();
    if (blank == nullptr || state_.released.any)
      return false;
    return blank->mark(contact_.longest_edges(blank->settings().edge_share, blank->settings().rim));
  }


  void Model::renumber()
  {
    for (auto &support : actors_.supports)
      support.renumber(*actors_.blank);
    for (auto &load : actors_.loads)
      load.renumber(*actors_.blank);
    number_unknowns();
  }


  void Model::refine()
  {
    std::vector<Vector> fields{state_.unknowns, state_.hold};
    std::vector<double> travels;
    for (const auto &pair : actors_.interfaces)
      travels.push_back(pair->tool().force_driven() ? state_.unknowns[pair->travel_dof()] : 0.);
    actors_.blank->adaptive()->refine(fields);
    renumber();
    set_prescribed();
    const unsigned int n_blank = actors_.blank->n_dofs();
    for (unsigned int i = 0; i < n_blank; ++i)
    {
      state_.unknowns[i] = fields[0][i];
      state_.hold[i] = fields[1][i];
    }
    for (unsigned int p = 0; p < actors_.interfaces.size(); ++p)
    {
      auto &pair = *actors_.interfaces[p];
      if (pair.tool().force_driven())
        state_.unknowns[pair.travel_dof()] = travels[p];
      pair.transfer(state_.unknowns, actors_.blank->adaptive()->parent_nodes(pair.tool().side()));
      pair.start_multipliers(state_.unknowns);
    }
    // Forces of loads, of which the next commit takes the work; the supports do not move until then.
    Collector loads(state_.unknowns.size());
    assemble_loads(state_.unknowns, loads);
    for (unsigned int i = 0; i < n_blank; ++i)
      state_.load_forces[i] = is_prescribed_[i] ? 0. : -loads.residual[i];
  }
} // namespace deltaform
