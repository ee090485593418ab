#pragma once

#include <deltaform/conditions/conditions.h>
#include <deltaform/reports/accepted_increment.h>

namespace deltaform
{
  /// The largest of the values that are told one after the other, when it was, and how many there were.
  struct Worst
  {
    unsigned int n = 0;
    double value = 0., time = 0.;

    /// A value that is not positive does not count.
    void tell(const double the_value, const double the_time)
    {
      if (the_value <= 0.)
        return;
      ++n;
      if (the_value <= value)
        return;
      value = the_value;
      time = the_time;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &n &value &time;
    }
  };


  /// Warns of a number of the increments that should be zero, where it was largest.
  class WorstCondition : public SavedCondition<WorstCondition>
  {
  public:
    void observe(const AcceptedIncrement &increment) override
    {
      worst_.tell(value(increment), increment.time);
    }

    std::vector<std::string> warnings(bool) const override
    {
      return worst_.n == 0 ? std::vector<std::string>() : std::vector<std::string>{sentence(worst_)};
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &worst_;
    }

  private:
    virtual double value(const AcceptedIncrement &increment) const = 0;
    virtual std::string sentence(const Worst &worst) const = 0;

    Worst worst_;
  };
} // namespace deltaform
