#pragma once

#include <chrono>
#include <iosfwd>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Wall time and number of calls of named sections, the steps of timing.json. A section is looked up by its name
   * once; from then on its index serves, and timing costs two readings of the clock. If sections nest, the time of the
   * inner one counts in both.
   */
  class Timers
  {
  public:
    using Index = std::size_t;

    Timers();

    /// Index of the section @p name; a new one is made if there is none.
    Index section(const std::string &name);

    /// Adds the time between its construction and its destruction to a section.
    class Scope
    {
    public:
      Scope(Timers &timers, const Index index)
        : timers_(timers), index_(index), start_(Clock::now())
      {
      }
      ~Scope()
      {
        timers_.add(index_, std::chrono::duration<double>(Clock::now() - start_).count());
      }
      Scope(const Scope &) = delete;
      Scope &operator=(const Scope &) = delete;

    private:
      Timers &timers_;
      Index index_;
      std::chrono::steady_clock::time_point start_;
    };

    /// As Scope, less the time of the scopes within: what a step does apart from its named parts. These scopes must
    /// not nest.
    class Remainder
    {
    public:
      Remainder(Timers &timers, const Index index)
        : scope_(timers, index), timers_(timers), index_(index), named_(timers.named_)
      {
      }
      ~Remainder()
      {
        const double parts = timers_.named_ - named_;
        timers_.sections_[index_].seconds -= parts;
        timers_.named_ -= parts;
      }
      Remainder(const Remainder &) = delete;
      Remainder &operator=(const Remainder &) = delete;

    private:
      Scope scope_; // destroyed last: adds the whole time, of which the parts have been taken off
      Timers &timers_;
      Index index_;
      double named_;
    };

    void add(const Index index, const double seconds)
    {
      sections_[index].seconds += seconds;
      ++sections_[index].calls;
      named_ += seconds;
    }

    /// Seconds since this object was made.
    double total() const;

    double seconds(Index index) const;
    unsigned long calls(Index index) const;

    /// {"total": s, "sections": [{"name": ..., "calls": ..., "seconds": ...}, ...]}
    void write_json(std::ostream &out) const;

  private:
    using Clock = std::chrono::steady_clock;

    struct Section
    {
      std::string name;
      unsigned long calls = 0;
      double seconds = 0.;
    };

    Clock::time_point start_;
    std::vector<Section> sections_;
    double named_ = 0.; ///< sum of the seconds of all sections
  };
} // namespace deltaform
