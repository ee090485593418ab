#pragma once

#include <deltaform/reports/accepted_increment.h>
#include <deltaform/reports/columns.h>
#include <deltaform/stage/actors.h>

#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Ends a stage before its end time when something happens: the entry Ends when of its section. A condition holds at
   * the end of an increment; the increments before are shortened so that a limit is met within a thousandth of it
   * where the quantity goes smoothly.
   */
  class StageEnds
  {
  public:
    explicit StageEnds(const Actors &actors);

    /// Can the conditions of a stage be understood? @throws std::invalid_argument saying what cannot
    void check(const Stage &stage) const;

    /// Conditions of this stage are watched from here on; none of them holds. What was remembered of an earlier part
    /// of the stage, by load(), stays.
    void enter_stage(const Stage &stage);

    void observe(const AcceptedIncrement &increment);

    /// End the stage for the reason @p why, if there is one and nothing has ended it before.
    void end(const std::string &why)
    {
      if (reached_.empty())
        reached_ = why;
    }

    /// What has ended the stage, in words; empty: nothing.
    const std::string &reached() const
    {
      return reached_;
    }

    /// The end of the next increment: @p next, or an earlier time at which a limit will be met at the rate of
    /// the last increments.
    double shorten(double next) const;

    /// What it remembers, in bytes that only it understands.
    std::string save() const;
    void load(const std::string &bytes);

  private:
    enum class Kind : unsigned char
    {
      above,
      below,
      falls_to
    };

    struct Criterion
    {
      std::string text, quantity;
      Kind kind;
      double limit; ///< of falls_to: the share of the largest size
    };

    /// Of a criterion over time.
    struct Watched
    {
      double time = 0., value = 0.; ///< at the end of the last increment
      double from_time = 0., from_value = 0.; ///< where the rate is measured from: about the last full increment
      double largest = 0.; ///< size in this stage so far
      bool known = false;

      /// Of the value; zero if it is not known.
      double rate() const
      {
        return time > from_time ? (value - from_value) / (time - from_time) : 0.;
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &time &value &from_time &from_value &largest &known;
      }
    };

    std::vector<Criterion> parse(const std::string &text) const;
    Criterion parse_one(const std::string &text) const;

    /// The value at which a criterion begins to hold.
    static double bound(const Criterion &criterion, const Watched &watched);
    static bool holds(const Criterion &criterion, const Watched &watched);

    Columns quantities_;
    std::string stage_;
    std::vector<Criterion> criteria_;
    std::vector<Watched> watched_;
    std::string reached_;
  };
} // namespace deltaform
