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

    /**
     * Numbers in a table may be constant expressions themselves.
     * @throws std::invalid_argument with a sentence about what cannot be understood, for example times of a table that
     * do not increase.
     */
    TimeFunction(const std::string &text, const std::map<std::string, double> &constants);

    double operator()(double time) const;

    /**
     * The first time in [@p from, @p to] at which the function has the value @p value, or NaN if it has it nowhere.
     * An expression is searched on 512 equal intervals: a value it only takes between two crossings closer than that
     * may be missed. Values that differ by round-off count as equal.
     */
    double inverse(double value, double from, double to) const;

    /// True if the text does not depend on t.
    bool is_constant() const;

    const std::string &text() const;

  private:
    struct Implementation;
    struct FromExpression;
    struct FromTable;

    std::shared_ptr<const Implementation> implementation_; ///< null for a constant
    std::string text_;
    double constant_ = 0.;
  };
} // namespace deltaform
