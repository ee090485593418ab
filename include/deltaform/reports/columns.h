#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace deltaform
{
  class AcceptedIncrement;

  /**
   * What is reported of every accepted increment, a column of history.csv each. The part that has a number adds its
   * column: name, unit, meaning, and how the value is found.
   */
  class Columns
  {
  public:
    struct Column
    {
      std::string name;
      std::string dimension; ///< "length", "force", ...; "1" for pure numbers
      std::string meaning; ///< for doc/columns.md
    };

    using Cell = std::variant<double, std::string>;
    using Row = std::vector<Cell>;

    /// The cell of a number that may not be known, or not be finite: empty then.
    static Cell if_known(const double value)
    {
      return std::isfinite(value) ? Cell(value) : Cell(std::string());
    }

    /// Appends the cells of a group of columns, one each.
    using Values = std::function<void(const AcceptedIncrement &, Row &)>;

    /// Columns whose values are found together.
    void add(std::vector<Column> columns, Values values)
    {
      columns_.insert(columns_.end(), columns.begin(), columns.end());
      groups_.push_back(std::move(values));
    }

    const std::vector<Column> &columns() const
    {
      return columns_;
    }

    Row row(const AcceptedIncrement &increment) const
    {
      Row result;
      result.reserve(columns_.size());
      for (const auto &values : groups_)
        values(increment, result);
      return result;
    }

  private:
    std::vector<Column> columns_;
    std::vector<Values> groups_;
  };
} // namespace deltaform
