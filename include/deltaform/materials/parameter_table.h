#pragma once

#include <deltaform/parameters/range.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace deltaform
{
  /// A number of a law, and what a scene has to know about it.
  template <typename Law>
  struct Parameter
  {
    std::string name; ///< of the entry in a scene
    double Law::*member;
    Range range;
    std::string unit; ///< dimension: "stress", "1"
    std::string sentence;
    double value; ///< default, or an example for documentation and tests if required
    bool required = true;
  };

  /// What holds between the parameters of a law; @p parameter is the one to blame if it does not.
  template <typename Law>
  struct ParameterCondition
  {
    std::string parameter, sentence;
    bool (*holds)(const Law &);
  };

  /**
   * All parameters of a law that is a value, once: scenes, the documentation, tests and fits (bounds, start values) are
   * made from this table.
   */
  template <typename Law>
  struct ParameterTable
  {
    std::vector<Parameter<Law>> parameters;
    std::vector<ParameterCondition<Law>> conditions = {};

    /// The law with its defaults and examples.
    Law example() const
    {
      Law law{};
      for (const auto &parameter : parameters)
        law.*parameter.member = parameter.value;
      return law;
    }

    /// @throws std::invalid_argument if a law made without a scene is none; the message names the parameter.
    void check(const Law &law) const
    {
      for (const auto &parameter : parameters)
        if (!parameter.range.contains(law.*parameter.member))
          throw std::invalid_argument(parameter.name + ": must lie in " + parameter.range.to_string());
      for (const auto &condition : conditions)
        if (!condition.holds(law))
          throw std::invalid_argument(condition.parameter + ": " + condition.sentence);
    }
  };
} // namespace deltaform
