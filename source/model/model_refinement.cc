// A finer mesh between two increments: all that hangs on the unknowns follows.
#include <deltaform/blanks/refinement.h>
#include <deltaform/model/model.h>

namespace deltaform
{
  bool Model::mark()
  {
    const RefinementSettings *settings = actors_.blank->refinement();
    if (settings == nullptr || state_.released.any)
      return false;
    return actors_.blank->mark(contact_.longest_edges(settings->edge_share, settings->rim));
  }


  void Model::renumber()
  {
    for (auto &load : actors_.loads)
      load->renumber();
    number_unknowns();
    supports_.renumber();
  }


  void Model::refine()
  {
    std::vector<Vector> fields{state_.unknowns, state_.hold};
    std::vector<double> travels;
    for (const auto &interface : actors_.interfaces)
      travels.push_back(interface->tool().force_driven() ? state_.unknowns[interface->travel_dof()] : 0.);
    actors_.blank->refine(fields);
    renumber();
    const unsigned int n_blank = actors_.blank->n_dofs();
    for (unsigned int i = 0; i < n_blank; ++i)
    {
      state_.unknowns[i] = fields[0][i];
      state_.hold[i] = fields[1][i];
    }
    for (unsigned int p = 0; p < actors_.interfaces.size(); ++p)
    {
      auto &interface = *actors_.interfaces[p];
      if (interface.tool().force_driven())
        state_.unknowns[interface.travel_dof()] = travels[p];
      interface.transfer(state_.unknowns, actors_.blank->heritage(interface.tool().side()));
      interface.start_multipliers(state_.unknowns);
    }
    book_.renew_loads(state_);
  }
} // namespace deltaform
