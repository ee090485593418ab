#pragma once

#include <deque>
#include <string>

namespace deltaform
{
  /// How fast a stage goes forward: many increments that all succeed but are far too short never end it.
  class Pace
  {
  public:
    static constexpr unsigned int window = 1000; ///< increments that tell the pace

    /// @param begin of the stage
    explicit Pace(const double begin = 0.)
      : times_{begin}
    {
    }

    /// An increment was accepted that ends at @p time.
    void accept(double time);

    /// Increments from the last one to @p end at the pace of the last ones; 0 as long as there were fewer.
    double left(double end) const;

    /// Why the stage does not get to @p end: it takes fifty thousand increments more, and more than the @p most
    /// that are allowed in all. Empty if it does.
    std::string never_ends(double end, unsigned int most) const;

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &times_;
    }

  private:
    std::deque<double> times_; ///< ends of the last increments, and where the first of them began
  };
} // namespace deltaform
