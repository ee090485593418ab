// A finer mesh between two increments: all that hangs on the unknowns follows.
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
    for (auto &load : actors_.loads)
      load->renumber();
    discretization_.renumber();
    supports_.renumber();
    clear_state();
  }


  void Model::refine()
  {
    std::vector<Vector> fields{state_.unknowns, state_.hold};
    const std::vector<double> travels = contact_.travels(state_.unknowns);
    std::vector<double> sizes;
    for (const auto &load : actors_.loads)
      sizes.push_back(load->follows_way() ? state_.unknowns[load->unknown()] : 0.);
    actors_.blank->adaptive()->refine(fields);
    renumber();
    const unsigned int n_blank = actors_.blank->n_dofs();
    for (unsigned int i = 0; i < n_blank; ++i)
    {
      state_.unknowns[i] = fields[0][i];
      state_.hold[i] = fields[1][i];
    }
    for (unsigned int i = 0; i < sizes.size(); ++i)
      if (actors_.loads[i]->follows_way())
        state_.unknowns[actors_.loads[i]->unknown()] = sizes[i];
    contact_.transfer(travels, state_.unknowns);
    book_.renew_loads(state_);
  }
} // namespace deltaform
