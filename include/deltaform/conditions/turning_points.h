#pragma once

#include <vector>

namespace deltaform
{
  /// Where a quantity that goes up and down turns.
  class TurningPoints
  {
  public:
    /// The next value. Swings of less than a twentieth of the largest magnitude so far are lost.
    void add(double value);

    /// What lies between one turn and the next, of swings of at least @p least; neither the first way nor the last,
    /// which are not over.
    std::vector<double> swings(double least) const;

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &turns_ &lowest_ &highest_ &largest_ &is_empty_;
    }

  private:
    /// Go on to the next value, and turn if it lies back by @p least.
    void go_to(double value, double least);

    std::vector<double> turns_; ///< where it began, turns, the last extreme; none before the first swing
    double lowest_ = 0., highest_ = 0.; ///< before the first swing
    double largest_ = 0.; ///< magnitude
    bool is_empty_ = true;
  };
} // namespace deltaform
