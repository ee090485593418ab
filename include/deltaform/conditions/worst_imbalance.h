#pragma once

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <vector>

namespace deltaform
{
  /// Increments whose forces do not balance, and which of them matters. What is left of a tool that hardly touches yet
  /// may be all of its force, and nothing of what comes later: so they are judged when the run has ended.
  class WorstImbalance
  {
  public:
    struct Entry
    {
      double error = 0.; ///< what is left, over the largest force of the increment
      double force = 0.; ///< what is left
      double time = 0.;

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &error &force &time;
      }
    };

    /// An increment that ends at @p time, with its error over its largest force, which is @p largest_force, or over a
    /// thousandth of the largest so far (see ForceBook::balance_error()).
    void tell(const double error, const double largest_force, const double time)
    {
      constexpr double worth_a_look = 1e-3;
      largest_force_ = std::max(largest_force_, largest_force);
      if (error > worth_a_look)
        entries_.push_back({error, error * std::max(largest_force, 1e-3 * largest_force_), time});
    }

    /// That with the largest error, of those that leave more than 1e-6 of the largest force so far; null: none.
    const Entry *worst() const
    {
      constexpr double least_share = 1e-6;
      const Entry *result = nullptr;
      for (const auto &entry : entries_)
        if (!(entry.force < least_share * largest_force_) && (result == nullptr || entry.error > result->error))
          result = &entry;
      return result;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &largest_force_ &entries_;
    }

  private:
    double largest_force_ = 0.; ///< so far
    std::vector<Entry> entries_;
  };
} // namespace deltaform
