#pragma once

#include <deltaform/base/csv_writer.h>

#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /// The file history.csv: one row per increment, on disk as soon as it is known. Columns are part of the interface.
  class History
  {
  public:
    /**
     * @param path         of the file
     * @param comments     lines for its head, without "#"
     * @param columns      the first one counts the increments
     * @param resume_after go on with the file on disk, without what follows this increment
     * @throws SceneError if the file cannot be written, or if the one to go on with has other columns
     */
    History(const std::string &path, const std::vector<std::string> &comments,
            const std::vector<CsvWriter::Column> &columns, std::optional<unsigned int> resume_after = std::nullopt);

    void append(const std::vector<CsvWriter::Cell> &row);

  private:
    CsvWriter file_;
  };
} // namespace deltaform
