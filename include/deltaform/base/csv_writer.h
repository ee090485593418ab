#pragma once

#include <fstream>
#include <string>
#include <variant>
#include <vector>

namespace deltaform
{
  /**
   * A table on disk that grows row by row: comment lines that open with '#', the last of them the units, one line of
   * column names, rows with 10 significant digits. Every row is flushed, so that a killed run leaves what it computed.
   */
  class CsvWriter
  {
  public:
    struct Column
    {
      std::string name;
      std::string unit = "1"; ///< dimension: "length", "force", ...; "1" for pure numbers
    };

    using Cell = std::variant<double, std::string>;

    /**
     * Begin a new file.
     * @throws SceneError if it cannot be written.
     */
    CsvWriter(const std::string &path, const std::vector<std::string> &comments, const std::vector<Column> &columns);

    /// Append a row with one value per column. @throws SceneError if the disk does not take it.
    void row(const std::vector<double> &values);

    /// Append a row that also contains words; they are quoted where CSV demands it.
    void row_of_cells(const std::vector<Cell> &cells);

    const std::string &path() const;

  private:
    void finish_row(std::size_t n_values);

    std::string path_;
    std::size_t n_columns_;
    std::ofstream file_;
  };
} // namespace deltaform
