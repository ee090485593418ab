#pragma once

#include <deltaform/base/csv_writer.h>

#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Open a history that is on disk to append to it. Rows after @p last_increment, and a last row that was not written
   * to its end, are dropped. The old file stays as it is until the new one is complete.
   * @throws SceneError if there is no such file, or if it has other columns.
   */
  CsvWriter reopen_history(const std::string &path,
                           const std::vector<std::string> &comments,
                           const std::vector<CsvWriter::Column> &columns,
                           unsigned int last_increment);
} // namespace deltaform
