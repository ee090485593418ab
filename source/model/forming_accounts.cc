// What the committed state adds up to.
#include <deltaform/contact/contact_measures.h>
#include <deltaform/model/forming_problem.h>

#include <algorithm>
#include <limits>

namespace deltaform
{
  EnergyAccount FormingProblem::energies() const
  {
    EnergyAccount account;
    if (!energies_wanted_)
      return account;
    ContactEnergy contact;
    for (const auto &pair : actors_.pairs)
      contact += pair->energy();
    const BlankEnergy blank = actors_.blank->energy();
    account.tool_work = state_.work.tools;
    account.load_work = state_.work.loads;
    account.elastic = blank.elastic;
    account.plastic = blank.plastic;
    account.friction = contact.friction;
    account.friction_error = contact.friction_error();
    account.contact = contact.stored;
    account.epsilon_work = contact.epsilon;
    account.thickness_work = contact.thickness + blank.normal;
    return account;
  }


  ContactAccount FormingProblem::contact() const
  {
    ContactAccount account;
    unsigned int n_at_bound = 0;
    account.min_epsilon = std::numeric_limits<double>::infinity();
    for (const auto *pair : active_pairs_)
    {
      for (unsigned int i = 0; i < pair->n_nodes(); ++i)
      {
        const ContactPointState &state = pair->committed()[i];
        if (!state.touching)
          continue;
        ++account.n_touching;
        account.max_penetration = std::max(account.max_penetration, state.penetration());
        account.max_penetration_over_delta =
          std::max(account.max_penetration_over_delta, state.penetration() / state.delta);
        account.min_epsilon = std::min(account.min_epsilon, state.penalty_factor);
        account.max_epsilon = std::max(account.max_epsilon, state.penalty_factor);
        n_at_bound += pair->governed_by_floor(i);
      }
      account.max_penetration_between_nodes =
        std::max(account.max_penetration_between_nodes, penetration_between_nodes(*pair, state_.unknowns));
    }
    if (account.n_touching == 0)
      account.min_epsilon = 0.;
    else
      account.floor_share = static_cast<double>(n_at_bound) / account.n_touching;
    return account;
  }
} // namespace deltaform
