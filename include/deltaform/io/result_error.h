#pragma once

#include <stdexcept>

namespace deltaform
{
  /// What was computed cannot be used any further: exit status 2. What was written before stays.
  class ResultError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace deltaform
