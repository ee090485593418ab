#pragma once

#include <deltaform/assembly/types.h>

#include <string>

namespace deltaform
{
  /// What physics can cause: not an exception, because the answer is a shorter step. The worst of all points counts.
  struct Status
  {
    enum class Outcome : unsigned char
    {
      good,
      shorten_step ///< the state cannot be reached in one step: the step control takes a smaller one
    };

    Outcome outcome = Outcome::good;
    const char *cause = ""; ///< a sentence in the language of the law, a string literal
    /// Where it happened: index of the point in the batch, later of the cell or node (invalid_index: nowhere in
    /// particular).
    unsigned int place = invalid_index;

    bool good() const
    {
      return outcome == Outcome::good;
    }

    /// Keep the worse of the two.
    void merge(const Status &other)
    {
      if (other.outcome > outcome)
        *this = other;
    }

    static Status shorten(const char *cause, const unsigned int place = invalid_index)
    {
      return {Outcome::shorten_step, cause, place};
    }
  };
} // namespace deltaform
