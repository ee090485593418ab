#pragma once

#include <deltaform/contact/augmentation.h>
#include <deltaform/increment/equations.h>
#include <deltaform/solver/system.h>
#include <deltaform/stage/contact_set.h>

#include <vector>

namespace deltaform
{
  /**
   * Contact while the equations are solved: when penalty factors are due, their corrections, and the inequalities,
   * which are active where a point touches. All that it remembers belongs to one solve.
   */
  class ContactSolve : public ActiveSet
  {
  public:
    ContactSolve(const Actors &actors, const ContactSet &contact);

    /// An increment that ends at @p time begins; what was tried before is discarded.
    void begin_increment(const Vector &committed, double time);

    /// Let contact have a share of its stiffness at first. @return false if no interface exists
    bool soften();

    /// Will the next assembly need the tangent of the blank for the penalty factors?
    bool factors_due() const
    {
      return factors_due_;
    }

    /// Let the rule give the penalty factors where it is its turn. @param body the tangent of the body at @p q, before
    /// any other term is added @param tangent is that of contact needed too?
    void read_body(const Vector &q, const System &body, bool tangent);

    /// The contact set has been assembled with its tangent: has its set of touching points been met before?
    void remember_set();

    /// See Equations.
    ///@{
    unsigned int correct_early();
    unsigned int correct(const Vector &q); ///< penalty factors and shifts
    ///@}

    /// @name ActiveSet
    ///@{
    bool foresee(const Vector &q, const Vector &d) override;
    void peel(unsigned int reach) override;
    std::size_t signature() const override;
    void prepare_step(const Vector &d) override;
    void advance(double factor) override;
    bool changed() const override;
    unsigned int patience() const override;
    bool consistent(double allowed_tension) const override;
    void keep() override;
    void go_back() override;
    ///@}

  private:
    const Actors &actors_;
    const ContactSet &contact_;
    Augmentation augmentation_;
    std::vector<std::size_t> visited_; ///< sets of touching points met in this solve
    bool cycling_ = false; ///< one of them was met again
    bool factors_due_ = false; ///< the rule has to predict in the next assembly
  };
} // namespace deltaform
