#include <deltaform/contact/deepest_place.h>
#include <deltaform/stage/contact_account.h>

#include <algorithm>
#include <limits>

namespace deltaform
{
  namespace
  {
    void add_deepest(const ContactInterface &interface, const unsigned int tool, const Vector &q,
                     ContactAccount &account)
    {
      const DeepestPlaces found = deepest_places(interface, q);
      account.max_penetration_between_nodes = std::max(account.max_penetration_between_nodes, found.anywhere.depth);
      const auto [depth, place] = found.off_corners;
      const double delta = depth > 0. ? interface.allowed_penetration() : 0.;
      if (depth > account.deepest.over_delta * delta)
        account.deepest = {depth / delta, depth, place, tool};
    }
  } // namespace


  ContactAccount contact_account(const ContactSet &contact, const Actors &actors, const Vector &q)
  {
    ContactAccount account;
    unsigned int n_at_bound = 0;
    account.min_epsilon = std::numeric_limits<double>::infinity();
    for (unsigned int tool = 0; tool < actors.interfaces.size(); ++tool)
    {
      const ContactInterface &interface = *actors.interfaces[tool];
      if (!contact.takes_part(interface))
        continue;
      interface.projector().for_near_points([&](const unsigned int i) {
        const ContactPointState &state = interface.committed()[i];
        if (!state.touching)
          return;
        ++account.n_touching;
        account.max_penetration = std::max(account.max_penetration, state.penetration());
        account.max_penetration_over_delta =
          std::max(account.max_penetration_over_delta, state.penetration() / state.delta);
        account.min_epsilon = std::min(account.min_epsilon, state.penalty_factor);
        account.max_epsilon = std::max(account.max_epsilon, state.penalty_factor);
        n_at_bound += interface.governed_by_floor(i);
      });
      add_deepest(interface, tool, q, account);
    }
    if (account.n_touching == 0)
      account.min_epsilon = 0.;
    else
      account.floor_share = static_cast<double>(n_at_bound) / account.n_touching;
    return account;
  }
} // namespace deltaform
