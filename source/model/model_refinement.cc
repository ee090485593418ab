// A finer mesh between two increments: all that hangs on the unknowns follows.
#include <deltaform/blanks/refinement.h>
#include <deltaform/contact/contact_measures.h>
#include <deltaform/model/model.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /// What moves next to the nodes: travels of tools, sizes of loads that follow a way. 0 of the others.
    struct Ways
    {
      std::vector<double> travels, loads;
    };

    Ways ways_of(const Vector &q, const Actors &actors, const ContactSet &contact)
    {
      Ways result{contact.travels(q), {}};
      for (const auto &load : actors.loads)
        result.loads.push_back(load->follows_way() ? q[load->unknown()] : 0.);
      return result;
    }

    void set_ways(const Ways &ways, const Actors &actors, const ContactSet &contact, Vector &q)
    {
      contact.set_travels(ways.travels, q);
      for (unsigned int i = 0; i < ways.loads.size(); ++i)
        if (actors.loads[i]->follows_way())
          q[actors.loads[i]->unknown()] = ways.loads[i];
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


  void Model::refine(std::vector<Vector> &steps)
  {
    std::vector<Vector> fields{state_.unknowns};
    fields.insert(fields.end(), steps.begin(), steps.end());
    std::vector<Ways> ways;
    for (const Vector &field : fields)
      ways.push_back(ways_of(field, actors_, contact_));
    body_.refine(fields);
    renumber();
    std::vector<Vector *> moved{&state_.unknowns};
    for (Vector &step : steps)
      moved.push_back(&step);
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
      moved[i]->reinit(state_.unknowns.size());
      std::copy_n(fields[i].begin(), actors_.blank->n_dofs(), moved[i]->begin());
      set_ways(ways[i], actors_, contact_, *moved[i]);
    }
    supports_.hold(state_); // where they are is where they are held
    contact_.transfer(state_.unknowns);
    book_.renew_loads(state_);
  }
} // namespace deltaform
