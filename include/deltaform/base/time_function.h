#pragma once

#include <map>
#include <memory>
#include <string>

namespace deltaform
{
  /**
   * A scalar function of time: a muParser expression in t, or a table "t0: v0, t1: v1, ..." interpolated linearly and
   * constant outside. Cheap to copy.
   */
  class TimeFunction
  {
  public:
    /// Identically @p value.
    explicit TimeFunction(double value = 0.);

    /// @throws std::invalid_argument with a sentence about what cannot be understood.
    TimeFunction(const std::string &text, const std::map<std::string, double> &constants);

    double operator()(double time) const;

    /// True if the text does not depend on t.
    bool is_constant() const;

    const std::string &text() const;

  private:
    struct Implementation;
    std::shared_ptr<const Implementation> implementation_;
    std::string text_;
    double constant_ = 0.;
  };
} // namespace deltaform
