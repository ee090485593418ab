// What the committed state adds up to.
#include <deltaform/model/model.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  EnergyAccount Model::energies() const
  {
    EnergyAccount account;
    if (!energies_wanted_)
      return account;
    ContactEnergy contact;
    for (const auto &pair : actors_.interfaces)
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


  ContactAccount Model::contact() const
  {
    return contact_.account(state_.unknowns);
  }


  double Model::balance_error() const
  {
    Tensor1 sum, largest;
    const auto count = [&](const Tensor1 &force) {
      sum += force;
      for (unsigned int d = 0; d < 2; ++d)
        largest[d] = std::max(largest[d], std::abs(force[d]));
    };
    for (const auto &force : state_.tool_forces)
      count(-force);
    for (const auto &force : state_.load_resultants)
      count(force);
    // An unknown that two supports hold counts once.
    std::vector<bool> counted(actors_.blank->n_dofs(), false);
    for (unsigned int i = 0; i < actors_.supports.size(); ++i)
    {
      const Support &support = actors_.supports[i];
      if (support.component == Component::rotation)
        continue;
      const unsigned int d = support.component == Component::r ? 0 : 1;
      Tensor1 force;
      if (support.acts_in(stage_name_))
        for (const auto dof : support.dofs)
        {
          if (!counted[dof] && !numbering_.is_fixed[dof])
            force[d] += state_.reactions[dof];
          counted[dof] = true;
        }
      else
        force[d] = reaction(i);
      count(force);
    }
    // What is left of much larger forces is round-off.
    const double floor = 1e-3 * state_.largest_resultant;
    double error = 0.;
    for (unsigned int d = actors_.blank->axisymmetric() ? 1 : 0; d < 2; ++d)
      if (const double size = std::max(largest[d], floor); size > 0.)
        error = std::max(error, std::abs(sum[d]) / size);
    return error;
  }
} // namespace deltaform
