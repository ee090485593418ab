#pragma once

#include <deltaform/io/archive.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// How fast a stage goes forward: many increments that all succeed but are far too short never end it.
  class Pace
  {
  public:
    static constexpr unsigned int window = 1000; ///< increments that tell the pace
    static constexpr unsigned int effort = 20000; ///< Newton iterations that tell it before

    /// @param begin of the stage
    explicit Pace(const double begin = 0.)
      : last_{{begin, 0.}}
    {
    }

    /// An increment was accepted that ends at @p time. @param iterations with those of its failed attempts
    void accept(double time, unsigned int iterations);

    /// Increments from the last one to @p end at the pace of the last ones; 0 as long as there were fewer.
    double left(double end) const;

    /// Newton iterations from there to @p end at the pace of the last increments, so many that they took the effort, or
    /// a window of them if that is less; 0 as long as there was neither.
    double iterations_left(double end) const;

    /// Why the stage does not get to @p end: it takes fifty thousand increments more, and more than the @p most
    /// that are allowed in all, or forty times as many iterations. Empty if it does.
    std::string never_ends(double end, unsigned int most) const;

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive_plain(archive, last_);
    }

  private:
    struct Accepted
    {
      double time, iterations;
    };

    bool is_known() const
    {
      return last_.size() > window;
    }

    std::vector<Accepted> last_; ///< the last increments, and where the first of them began
  };
} // namespace deltaform
