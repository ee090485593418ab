#pragma once

#include <deltaform/model/condition.h>

#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  struct Actors;

  /// Registers a condition by its name; the last line of the file that defines it.
  class ConditionEntry
  {
  public:
    using Maker = std::unique_ptr<Condition> (*)(const Actors &actors);

    /// @throws std::logic_error if the name is taken
    ConditionEntry(const std::string &name, Maker make);
  };

  /// Every condition there is, by the order of their names.
  std::vector<std::unique_ptr<Condition>> make_conditions(const Actors &actors);
} // namespace deltaform
