#pragma once

#include <deltaform/io/csv_writer.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * The file history.csv: one row per increment, on disk as soon as it is known. Columns are part of the interface. A
   * history that is resumed keeps its columns: those that the scene no longer asks for are empty from then on, those
   * that it asks for only now are left out.
   */
  class History
  {
  public:
    /// How to go on with the file on disk.
    struct Resumption
    {
      unsigned int increment = 0; ///< the last one that is kept; the file must reach it
      std::set<std::string> optional = {}; ///< columns that the file or the scene may lack
    };

    /**
     * Nothing is written yet.
     * @param path       of the file
     * @param comments   lines for its head, without "#"
     * @param columns    the first one counts the increments
     * @param resumption none: a new file
     * @throws SceneError if the file to go on with cannot be read, has other columns, or ends too early
     */
    History(const std::string &path, const std::vector<std::string> &comments,
            const std::vector<CsvWriter::Column> &columns, const std::optional<Resumption> &resumption = std::nullopt);

    /// Begin the file, or drop what follows the last increment that is kept. @throws SceneError if it cannot be written
    void open();

    /// @throws SceneError, ResultError as CsvWriter::row_of_cells()
    void append(const std::vector<CsvWriter::Cell> &row);

    /// Columns of the scene that the resumed file does not have.
    const std::vector<std::string> &left_out() const
    {
      return left_out_;
    }

  private:
    /// What is kept of the file on disk.
    void read(const Resumption &resumption);

    /// Which of the scene's columns each column of the file is.
    void match(const std::vector<std::string> &names, const Resumption &resumption);

    std::string path_;
    std::vector<std::string> comments_;
    std::vector<CsvWriter::Column> columns_; ///< of the scene
    std::optional<std::vector<std::string>> kept_; ///< rows of a file that is resumed
    std::vector<CsvWriter::Column> in_file_;
    std::vector<std::optional<std::size_t>> place_; ///< of each column of the file among the scene's
    std::vector<std::string> left_out_;
    std::optional<CsvWriter> file_;
  };
} // namespace deltaform
