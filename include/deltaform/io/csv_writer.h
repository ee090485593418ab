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
   * or, of a table that is written in one go, none before flush(). A row that the disk does not take is not there at
   * all. A number that is not finite never gets into a file; what is not known is an empty word.
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

    /// Go on with a table that is on disk, and has these @p columns. @throws SceneError if it cannot be written
    static CsvWriter append(const std::string &path, const std::vector<Column> &columns);

    /// Append a row with one value per column.
    /// @throws SceneError if the disk does not take it
    /// @throws ResultError if a value is not finite
    void row(const std::vector<double> &values);

    /// Append a row that also contains words; they are quoted where CSV demands it.
    void row_of_cells(const std::vector<Cell> &cells);

    /// Give the file to the system. @throws SceneError if the disk does not take it.
    void flush();

    const std::string &path() const;

  private:
    CsvWriter(const std::string &path, std::ios::openmode mode, std::vector<std::string> names, Flush flush);

    /// The cell of a column.
    std::string number(double value, std::size_t column) const;
    void finish_row(const std::string &cells, std::size_t n_values);

    std::string path_;
    Flush flush_;
    std::vector<std::string> names_; ///< of the columns
    std::ofstream file_;
    std::streamoff size_ = 0; ///< of the file after the last row that is whole
  };
} // namespace deltaform
