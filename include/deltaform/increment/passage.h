#pragma once

#include <deltaform/blanks/element_chain.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace deltaform
{
  class StiffnessView;

  /**
   * What the last elements did that have passed a tool. Where a sheet is drawn over a radius its elements pass one
   * after the other, and what a node does its neighbour did a while before, the *lag*:
   *
   *   q_i(t + l) - q_i(t) = q_j(t - lag + l) - q_j(t - lag),    j = i - 1 or i + 1.
   *
   * Lag and neighbour are those for which the bends of all elements over the last three increments are most like those
   * of their neighbours then. w is the share of this, over what the rates say, that was found in the increments that
   * followed, in the energy of the tangent. Derivation: doc/theory/solver.md.
   */
  class Passage
  {
  public:
    /// An increment of this @p length has led from @p before to @p now, where @p tangent was assembled last; from the
    /// rates alone the step @p expected was.
    void accept(const Vector &before,
                const Vector &now,
                const Vector &expected,
                double length,
                const StiffnessView &tangent,
                const ElementChain &chain);

    /// The step of the next increment, where the rates say @p expected: nothing if that is the better guess.
    std::optional<Vector> step(const Vector &expected, double length, const ElementChain &chain) const;

    /// An increment has failed that may have started from it: what it is worth has to be found anew.
    void distrust()
    {
      found_ = looked_for_ = 0.;
    }

    /// No longer increment, where steps follow it: an element is bent over a radius in several of them.
    double longest() const;

    /// w; 0 if it is not used
    double weight() const;

    /// Time in which an element passes; 0: unknown.
    double lag() const
    {
      return lag_;
    }

    /// Was it made with so many unknowns?
    bool fits(std::size_t n_unknowns) const;

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &times_ &states_ &lag_ &towards_end_ &mismatch_ &turned_ &found_ &looked_for_;
    }

  private:
    class Bends;

    void remember(const Vector &before, const Vector &now, double length);
    void find_lag(const Bends &bends);

    /// The increment of the neighbours a lag before; nothing if they are not known.
    std::optional<Vector> of_neighbours(double length, const ElementChain &chain) const;
    Vector state(double time) const;

    std::vector<double> times_; ///< of the states, from the first increment that is known
    std::vector<Vector> states_;
    double lag_ = 0.;
    bool towards_end_ = true; ///< does the sheet move towards its end: was it the node ahead that did it before?
    double mismatch_ = 1.; ///< of the bends of the last increments, over these, squared
    double turned_ = 0.; ///< bend of an element in the time of the lag, at most (rad)
    double found_ = 0., looked_for_ = 0.; ///< smoothed energies; their ratio is w
  };
} // namespace deltaform
