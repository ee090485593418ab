#include <deltaform/base/csv_writer.h>
#include <deltaform/base/ranks.h>
#include <deltaform/base/scene_error.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <charconv>
#include <cstring>

namespace deltaform
{
  namespace
  {
    std::string number(const double value)
    {
      char buffer[32]; // as by printf("%.10g")
      return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 10).ptr};
    }

    std::string word(const std::string &text)
    {
      if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
      std::string result = "\"";
      for (const char c : text)
        (result += (c == '"' ? "\"" : "")) += c;
      return result + "\"";
    }
  } // namespace

  CsvWriter::CsvWriter(const std::string &path,
                       const std::vector<std::string> &comments,
                       const std::vector<Column> &columns,
                       const Flush flush)
    : path_(path), flush_(flush), n_columns_(columns.size()), file_(ranks::first() ? path : "/dev/null")
  {
    if (!file_)
      throw SceneError("Cannot write '" + path_ + "': " + std::strerror(errno) + ".");
    for (const auto &comment : comments)
      file_ << "# " << comment << '\n';
    file_ << "# units: ";
    for (std::size_t i = 0; i < n_columns_; ++i)
      file_ << (i == 0 ? "" : ",") << columns[i].unit;
    file_ << '\n';
    for (std::size_t i = 0; i < n_columns_; ++i)
      file_ << (i == 0 ? "" : ",") << word(columns[i].name);
    finish_row(n_columns_);
  }

  void CsvWriter::row(const std::vector<double> &values)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
      file_ << (i == 0 ? "" : ",") << number(values[i]);
    finish_row(values.size());
  }

  void CsvWriter::row_of_cells(const std::vector<Cell> &cells)
  {
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      const auto *const value = std::get_if<double>(&cells[i]);
      file_ << (i == 0 ? "" : ",") << (value != nullptr ? number(*value) : word(std::get<std::string>(cells[i])));
    }
    finish_row(cells.size());
  }

  const std::string &CsvWriter::path() const
  {
    return path_;
  }

  void CsvWriter::finish_row(const std::size_t n_values)
  {
    AssertThrow(n_values == n_columns_,
                dealii::ExcMessage("A row of '" + path_ + "' has " + std::to_string(n_values) + " values for " +
                                   std::to_string(n_columns_) + " columns."));
    file_ << '\n';
    if (flush_ == Flush::every_row)
      flush();
  }

  void CsvWriter::flush()
  {
    file_.flush();
    if (!file_)
      throw SceneError("Cannot write '" + path_ + "' any further: " + std::strerror(errno) + ".");
  }
} // namespace deltaform
