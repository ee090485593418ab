#pragma once

#include <deltaform/contact/augmentation.h>
#include <deltaform/model/accounts.h>
#include <deltaform/model/actors.h>
#include <deltaform/model/equations.h>
#include <deltaform/solver/system.h>

#include <array>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * The contact interfaces of a stage as one part of the equations: their penalty factors, residual and tangent, and
   * the inequalities, which are active where a point touches.
   */
  class ContactSet : public ActiveSet
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

    /// An increment that ends at @p time begins; what was tried before is forgotten.
    void begin_increment(double time);

    /// Start the continuation of first touches. @return false if no interface exists
    bool soften(double share);

    /// Will the next assembly need the tangent of the blank for the penalty factors?
    bool factors_due() const
    {
      return factors_due_;
    }

    /// Let the rule give the penalty factors where it is its turn. @p system has the blank's terms and none of contact.
    void predict_factors(const Vector &q, const System &system, bool tangent);

    /// Residual and tangent of all interfaces.
    void assemble(const Vector &q, System &system, bool tangent);

    /// Shorten the travels of tools in the step @p d that nothing resists. @return the share of the step that moves no
    /// tool by more than @p length
    double limit_travels(Vector &d, double length) const;

    /// After convergence: @return how many penalty factors and shifts were changed
    unsigned int correct();

    /// Where the promise p <= delta is broken in the trial state, in words; empty if it is kept or none was made.
    std::string broken_promise(const Vector &committed) const;

    /// Longest allowed undeformed edges of both sides of the blank, edge by edge.
    std::array<std::vector<double>, 2> longest_edges(double share, bool rim) const;

    /// Accept the trial state at @p q.
    void commit(const Vector &q);

    /// The thickness has changed: count its work, and tell the blank the contact pressure of the next increments.
    void refresh(const Vector &q);

    /// Of the committed state.
    ContactAccount account(const Vector &q) const;

    /// @name ActiveSet
    ///@{
    void prepare_step(const Vector &d) override;
    void advance(double factor) override;
    bool changed() const override;
    unsigned int patience() const override;
    bool consistent(double allowed_tension) const override;
    void allow_slack(double force) override;
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
