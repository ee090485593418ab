#pragma once

#include <deltaform/stage/body.h>
#include <deltaform/stage/contact_set.h>

#include <vector>

namespace deltaform
{
  /**
   * The terms that take part in a stage: the body first, contact last, the others between them. They are accepted in
   * the opposite order, because contact reads the thickness that the body then updates.
   */
  class StageTerms
  {
  public:
    StageTerms(Body &body, ContactSet &contact);

    void enter_stage(const std::vector<Term *> &others);

    /// All but the body and contact.
    Status assemble_others(const Vector &q, double time, AssemblyTarget &target) const;

    void accept(const Vector &q, double time, double duration);

    /// Switch energies off. @param of_contact those of contact, too
    void count_no_energy(bool of_contact);

    /// Of the accepted state, with the works of tools and of loads, and without what plastic flow had dissipated
    /// before; zero where energies are off.
    EnergyAccount energies(double tool_work, double load_work, double dissipated_before) const;

  private:
    std::vector<Term *> all_;
    bool counts_energy_ = true;
  };
} // namespace deltaform
