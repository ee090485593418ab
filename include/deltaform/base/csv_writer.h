#pragma once

#include <fstream>
#include <string>
#include <variant>
#include <vector>

namespace deltaform
{
  /**
   * A table on disk that grows row by row: comment lines that open with '#', the last of them the units, one line of
   * column names, rows with 10 significant digits. Every row is flushed, so that a killed run leaves what it computed,
   * or, of a table that is written in one go, none before flush().
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

    enum class Flush
    {
      every_row,
      when_told
    };

    /**
     * Begin a new file.
     * @throws SceneError if it cannot be written.
     */
    CsvWriter(const std::string &path,
              const std::vector<std::string> &comments,
              const std::vector<Column> &columns,
              Flush flush = Flush::every_row);

    /// Append a row with one value per column. @throws SceneError if the disk does not take it.
    void row(const std::vector<double> &values);

    /// Append a row that also contains words; they are quoted where CSV demands it.
    void row_of_cells(const std::vector<Cell> &cells);

    /// Give the file to the system. @throws SceneError if the disk does not take it.
    void flush();

    const std::string &path() const;

  private:
    void finish_row(std::size_t n_values);

    std::string path_;
    Flush flush_;
    std::size_t n_columns_;
    std::ofstream file_;
  };
} // namespace deltaform
