#pragma once

#include <deltaform/assembly/accounts.h>
#include <deltaform/assembly/term.h>
#include <deltaform/stage/actors.h>

#include <array>
#include <string>
#include <vector>

namespace deltaform
{
  struct EdgeWishes;

  /**
   * The contact interfaces of a stage as one part of the equations. What is found out while these are solved is
   * ContactSolve's.
   */
  class ContactSet : public Term
  {
  public:
    explicit ContactSet(Actors &actors);

    /// Interfaces whose tools exist in the stage take part from here on.
    void enter_stage(const Stage &stage);

    const std::vector<ContactInterface *> &interfaces() const
    {
      return active_;
    }

    bool empty() const
    {
      return active_.empty();
    }

    bool takes_part(const ContactInterface &interface) const;

    /**
     * A stage begins at @p time: bring tools that are driven by a force into contact (a force without resistance has no
     * equilibrium), and remember where the contact points are.
     * @param q the unknowns, of which the travels change
     * @param extent of the blank (length)
     * @return names of the tools that have not found the blank
     */
    std::vector<std::string> begin_stage(double time, double extent, Vector &q);

    /// Travels of the tools at @p q; 0 of those that follow a motion.
    std::vector<double> travels(const Vector &q) const;

    /// Set what travels() tells.
    void set_travels(const std::vector<double> &travels, Vector &q) const;

    /// The blank was refined at @p q, of which multipliers are still to be set: contact of the old points goes over to
    /// the new ones.
    void transfer(Vector &q);

    /// The blank has other nodes: points of all of them, without contact.
    void resize();

    /// Contact points of all interfaces, in bytes that only they understand.
    std::vector<std::string> save() const;
    void load(const std::vector<std::string> &bytes);

    /// Shorten the travels of tools in the step @p d that nothing resists. @return the share of the step that moves no
    /// tool by more than @p length
    double limit_travels(Vector &d, double length) const;

    /// Where penetration <= delta is broken in the trial state, in words; empty if it is kept or none was made.
    std::string broken_promise(const Vector &committed) const;

    /// Longest allowed undeformed edges of both sides of the blank in the committed state, edge by edge.
    std::array<std::vector<double>, 2> longest_edges(const Vector &committed, const EdgeWishes &wishes) const;

    /// @name Term
    ///@{
    /// Between multipliers and the blank, of all interfaces.
    void add_couplings(dealii::DynamicSparsityPattern &pattern) const override;
    Status assemble(const Vector &q, double time, AssemblyTarget &target) const override;
    void accept(const Vector &q, double time, double duration) override;
    void add_to(EnergyAccount &account) const override;
    void count_no_energy() override;
    ///@}

  private:
    Actors &actors_;
    std::vector<ContactInterface *> active_;
  };
} // namespace deltaform
