#include "history_file.h"

#include <deltaform/results/history.h>

namespace deltaform
{
  History::History(const std::string &path, const std::vector<std::string> &comments,
                   const std::vector<CsvWriter::Column> &columns, const std::optional<unsigned int> resume_after)
    : file_(resume_after ? reopen_history(path, comments, columns, *resume_after) : CsvWriter(path, comments, columns))
  {
  }


  void History::append(const std::vector<CsvWriter::Cell> &row)
  {
    file_.row_of_cells(row);
  }
} // namespace deltaform
