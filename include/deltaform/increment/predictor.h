#pragma once

#include <deltaform/increment/passage.h>

#include <vector>

namespace deltaform
{
  class StiffnessView;

  /**
   * Where Newton's method starts: at the state to which the last increments lead,
   *
   *   q = q_n + l v_n + w l (l + l_n)/2 a_n,
   *
   * with the rate v_n over the last increment, of length l_n, and its change a_n from the one before it. a_n is trend
   * and noise of contact points that come and go. w is half of what was found of it again in the increments that
   * followed, in the energy of the tangent K: of the mean of (a_n . K a_n-1)/(a_n-1 . K a_n-1), smoothed exponentially.
   * Where a sheet is drawn over a tool, what the elements before did is the better guess: Passage.
   * Derivation: doc/theory/solver.md; what it saves: doc/decisions.
   */
  class Predictor
  {
  public:
    /// The next increment continues none, and starts from the committed state.
    void restart()
    {
      *this = Predictor();
    }

    /// The last increment, l_n v_n, and l_n^2 a_n, as far as they are known.
    std::vector<Vector> steps() const;

    /// The blank has other elements, and these are steps() of its unknowns. What its old elements did is forgotten.
    void renumber(std::vector<Vector> steps);

    /// An increment of this @p length has led from @p before to @p now, where @p tangent was assembled last.
    void accept(const Vector &before,
                const Vector &now,
                double length,
                const StiffnessView &tangent,
                const ElementChain &chain = ElementChain::none());

    /// Move @p q from the committed state to where an increment of this @p length starts.
    void predict(double length, Vector &q, const ElementChain &chain = ElementChain::none()) const;

    Passage &passage()
    {
      return passage_;
    }

    const Passage &passage() const
    {
      return passage_;
    }

    /// Length of the last increment; 0: there is none that the next one continues, as the mesh was another.
    double last_length() const
    {
      return continues_ ? length_ : 0.;
    }

    /// w
    double weight() const;

    /// Was what it remembers made with so many unknowns?
    bool fits(const std::size_t n_unknowns) const
    {
      const auto as_many = [&](const Vector &v) { return v.size() == 0 || v.size() == n_unknowns; };
      return as_many(rate_) && as_many(change_) && passage_.fits(n_unknowns);
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &length_ &continues_ &rate_ &change_ &found_ &looks_ &passage_;
    }

  private:
    /// By the rates, without what is known of other elements.
    Vector step(double length) const;
    void look_for_change(const Vector &change, const StiffnessView &tangent);

    double length_ = 0.; ///< l_n
    bool continues_ = false; ///< is the mesh still that of the last increment?
    Vector rate_, change_; ///< v_n, a_n; empty: there is none
    double found_ = 0., looks_ = 0.; ///< smoothed sums of the shares found again, and of ones
    Passage passage_;
  };
} // namespace deltaform
