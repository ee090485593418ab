#pragma once

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
} // namespace deltaform
