// A finer mesh between two increments: all that hangs on the unknowns follows.
#include <deltaform/blanks/refinement.h>
#include <deltaform/contact/contact_measures.h>
#include <deltaform/model/model.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /// Of loads that follow a way; 0 of the others.
    std::vector<double> load_sizes(const Actors &actors, const Vector &q)
    {
      std::vector<double> sizes;
      for (const auto &load : actors.loads)
        sizes.push_back(load->follows_way() ? q[load->unknown()] : 0.);
      return sizes;
    }

    void set_load_sizes(const Actors &actors, const std::vector<double> &sizes, Vector &q)
    {
      for (unsigned int i = 0; i < sizes.size(); ++i)
        if (actors.loads[i]->follows_way())
          q[actors.loads[i]->unknown()] = sizes[i];
    }
  } // namespace


  bool Model::mark()
  {
    Adaptive *blank = actors_.blank->adaptive();
    if (blank == nullptr || state_.released.any)
      return false;
    const RefinementSettings &settings = blank->settings();
    // Moments alone bend elements evenly, and these are exact then.
    if (!settings.asked_for && actors_.tools.empty())
      return false;
    // The nodes of a path stay the same.
    for (const auto &load : actors_.loads)
      if (load->follows_path())
        return false;
    const EdgeWishes wishes{settings.edge_share, settings.rim, settings.smooth, blank->edge_lengths()};
    return blank->mark(contact_.longest_edges(state_.unknowns, wishes));
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
    const std::vector<double> sizes = load_sizes(actors_, state_.unknowns);
    body_.refine(fields);
    renumber();
    std::copy_n(fields[0].begin(), actors_.blank->n_dofs(), state_.unknowns.begin());
    std::copy_n(fields[1].begin(), actors_.blank->n_dofs(), state_.hold.begin());
    set_load_sizes(actors_, sizes, state_.unknowns);
    contact_.transfer(travels, state_.unknowns);
    book_.renew_loads(state_);
  }
} // namespace deltaform
