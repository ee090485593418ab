#pragma once

#include <deltaform/assembly/accounts.h>
#include <deltaform/assembly/term.h>
#include <deltaform/contact/augmentation.h>
#include <deltaform/increment/equations.h>
#include <deltaform/solver/system.h>
#include <deltaform/stage/actors.h>

#include <array>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * The contact interfaces of a stage as one part of the equations: their penalty factors, residual and tangent, and
   * the inequalities, which are active where a point touches.
   */
  class ContactSet : public Term, public ActiveSet
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

    /// The blank was refined at @p q, of which travels (as before) and multipliers are still to be set: contact of the
    /// old points goes over to the new ones.
    void transfer(const std::vector<double> &travels, Vector &q);

    /// The blank has other nodes: points of all of them, without contact.
    void resize();

    /// Contact points of all interfaces, in bytes that only they understand.
    std::vector<std::string> save() const;
    void load(const std::vector<std::string> &bytes);

    /// An increment that ends at @p time begins; what was tried before is discarded.
    void begin_increment(double time);

    /// Start the continuation of first touches. @return false if no interface exists
    bool soften(double share);

    /// Will the next assembly need the tangent of the blank for the penalty factors?
    bool factors_due() const
    {
      return factors_due_;
    }

    /// Shorten the travels of tools in the step @p d that nothing resists. @return the share of the step that moves no
    /// tool by more than @p length
    double limit_travels(Vector &d, double length) const;

    /// See Equations.
    ///@{
    unsigned int correct_early();
    unsigned int correct(); ///< penalty factors and shifts
    ///@}

    /// Where penetration <= delta is broken in the trial state, in words; empty if it is kept or none was made.
    std::string broken_promise(const Vector &committed) const;

    /// Longest allowed undeformed edges of both sides of the blank, edge by edge.
    std::array<std::vector<double>, 2> longest_edges(double share, bool rim) const;

    /// @name Term
    ///@{
    /// Let the rule give the penalty factors where it is its turn.
    void read_body(const Vector &q, const System &body, bool tangent) override;
    Status assemble(const Vector &q, double time, AssemblyTarget &target) override;
    void accept(const Vector &q) override;
    /// Count the work of the new thickness, and tell the blank the contact pressure of the next increments.
    void refresh(const Vector &q) override;
    void add_to(EnergyAccount &account) const override;
    void count_no_energy() override;
    ///@}

    /// @name ActiveSet
    ///@{
    bool foresee(const Vector &q, const Vector &d) override;
    void prepare_step(const Vector &d) override;
    void advance(double factor) override;
    bool changed() const override;
    unsigned int patience() const override;
    bool consistent(double allowed_tension) const override;
    void allow_status_tolerance(double force) override;
    ///@}

  private:
    Actors &actors_;
    std::vector<ContactInterface *> active_;
    Augmentation augmentation_;
    std::vector<std::size_t> visited_; ///< sets of touching points met in this solve
    bool cycling_ = false; ///< one of them was met again
    bool factors_due_ = false; ///< the rule has to predict in the next assembly
  };
} // namespace deltaform
