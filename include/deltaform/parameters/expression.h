#pragma once

#include <map>
#include <memory>
#include <string>

namespace deltaform
{
  /// Names with values that an expression may use, besides pi.
  using Constants = std::map<std::string, double>;

  /// A muParser expression in the time t. Cheap to copy. Not for use by several threads at once.
  class Expression
  {
  public:
    /// @throws std::invalid_argument with a sentence about what cannot be understood.
    Expression(const std::string &text, const Constants &constants);

    double operator()(double time) const;

    bool depends_on_time() const;

  private:
    struct Parser;
    std::shared_ptr<Parser> parser_;
  };

  /**
   * The value of a number or of a constant expression such as "0.035/2" or "pi/2".
   * @throws std::invalid_argument with a sentence if it is none, or not finite.
   */
  double evaluate_number(const std::string &text, const Constants &constants = {});
} // namespace deltaform
