#include <deltaform/model/support_set.h>

namespace deltaform
{
  SupportSet::SupportSet(Actors &actors, const Numbering &numbering)
    : actors_(actors), numbering_(numbering)
  {
    enter_stage("");
  }


  void SupportSet::enter_stage(const std::string &stage)
  {
    stage_ = stage;
    is_prescribed_ = numbering_.is_fixed;
    for (const auto &support : actors_.supports)
      if (support.acts_in(stage_))
        for (const auto dof : support.dofs)
          is_prescribed_[dof] = true;
    // The travel of a force-driven tool that is absent does not change.
    for (const auto &interface : actors_.interfaces)
      if (interface->tool().force_driven() && !interface->tool().exists_in(stage_))
        is_prescribed_[interface->travel_dof()] = true;
    // Nor does the size of a load that is absent.
    for (const auto &load : actors_.loads)
      if (load->follows_way() && !load->acts_in(stage_))
        is_prescribed_[load->unknown()] = true;
  }


  void SupportSet::renumber()
  {
    for (auto &support : actors_.supports)
      support.renumber(*actors_.blank);
    enter_stage(stage_);
  }


  Vector SupportSet::prescribed(const ModelState &state, const double time) const
  {
    Vector values = state.unknowns;
    for (const auto &support : actors_.supports)
      if (support.acts_in(stage_))
        for (unsigned int i = 0; i < support.dofs.size(); ++i)
        {
          const DofIndex dof = support.dofs[i];
          values[dof] = numbering_.is_fixed[dof] ? 0. : (support.hold ? state.hold[dof] : support.at(i, time));
        }
    return values;
  }


  void SupportSet::hold(ModelState &state) const
  {
    for (const auto &support : actors_.supports)
      if (support.acts_in(stage_))
        for (const auto dof : support.dofs)
          state.hold[dof] = state.unknowns[dof];
  }


  double SupportSet::reaction(const unsigned int support, const ModelState &state) const
  {
    std::vector<bool> none(actors_.blank->n_dofs(), false);
    return uncounted_reaction(support, state, none);
  }


  double SupportSet::uncounted_reaction(const unsigned int support,
                                        const ModelState &state,
                                        std::vector<bool> &counted) const
  {
    const Support &which = actors_.supports[support];
    if (!which.acts_in(stage_))
      return state.released.share(state.time) * state.released.of_supports[support];
    double sum = 0.;
    for (const auto dof : which.dofs)
    {
      if (!counted[dof] && !numbering_.is_fixed[dof])
        sum += state.reactions[dof];
      counted[dof] = true;
    }
    return sum;
  }
} // namespace deltaform
