#include <deltaform/stage/stage_terms.h>

#include <algorithm>

namespace deltaform
{
  StageTerms::StageTerms(Body &body, ContactSet &contact)
    : all_{&body, &contact}
  {
  }


  void StageTerms::enter_stage(const std::vector<Term *> &others)
  {
    Term *const body = all_.front(), *const contact = all_.back();
    all_ = {body};
    all_.insert(all_.end(), others.begin(), others.end());
    all_.push_back(contact);
  }


  Status StageTerms::assemble_others(const Vector &q, const double time, AssemblyTarget &target) const
  {
    for (unsigned int i = 1; i + 1 < all_.size(); ++i)
      if (const Status status = all_[i]->assemble(q, time, target); !status.good())
        return status;
    return {};
  }


  void StageTerms::accept(const Vector &q, const double time, const double duration)
  {
    std::for_each(all_.rbegin(), all_.rend(), [&](Term *const term) { term->accept(q, time, duration); });
  }


  void StageTerms::count_no_energy(const bool of_contact)
  {
    counts_energy_ = false;
    for (Term *const term : all_)
      if (of_contact || term != all_.back())
        term->count_no_energy();
  }


  EnergyAccount StageTerms::energies(const double tool_work, const double load_work,
                                     const double dissipated_before) const
  {
    EnergyAccount account;
    if (!counts_energy_)
      return account;
    account.tool_work = tool_work;
    account.load_work = load_work;
    for (const Term *const term : all_)
      term->add_to(account);
    account.plastic -= dissipated_before;
    return account;
  }
} // namespace deltaform
