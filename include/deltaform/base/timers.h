#pragma once

#include <chrono>
#include <iosfwd>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Wall time and calls of named steps. A section is looked up once and then known by its index, so that timing costs
   * two readings of the clock. Sections may nest; the inner time then counts in both.
   */
  class Timers
  {
  public:
    using Index = std::size_t;

    Timers();

    /// The index of the section called @p name, which is made if there is none yet.
    Index section(const std::string &name);

    /// Measures from its construction to its end.
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

    /// Measures what lies between its construction and its end and in none of the scopes between them, which must not
    /// nest: what a step does apart from its named parts.
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
      Scope scope_; // ends last, and adds what the parts were taken from
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
    double named_ = 0.; ///< sum of all seconds
  };
} // namespace deltaform
