#include <deltaform/io/csv_writer.h>
#include <deltaform/io/result_error.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/ranks.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

namespace deltaform
{
  namespace
  {
    std::string word(const std::string &text)
    {
      if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
      std::string result = "\"";
      for (const char c : text)
        (result += (c == '"' ? "\"" : "")) += c;
      return result + "\"";
    }

    std::vector<std::string> names_of(const std::vector<CsvWriter::Column> &columns)
    {
      std::vector<std::string> result;
      for (const auto &column : columns)
        result.push_back(column.name);
      return result;
    }
  } // namespace

  CsvWriter::CsvWriter(const std::string &path, const std::ios::openmode mode, std::vector<std::string> names,
                       const Flush flush)
    : path_(path), flush_(flush), names_(std::move(names)), file_(ranks::first() ? path : "/dev/null", mode)
  {
    if (!file_)
      throw SceneError("Cannot write '" + path_ + "': " + std::strerror(errno) + ".");
  }


  CsvWriter::CsvWriter(const std::string &path,
                       const std::vector<std::string> &comments,
                       const std::vector<Column> &columns,
                       const Flush flush)
    : CsvWriter(path, std::ios::out, names_of(columns), flush)
  {
    for (const auto &comment : comments)
      file_ << "# " << comment << '\n';
    file_ << "# units: ";
    for (std::size_t i = 0; i < columns.size(); ++i)
      file_ << (i == 0 ? "" : ",") << columns[i].unit;
    file_ << '\n';
    std::string head;
    for (std::size_t i = 0; i < columns.size(); ++i)
      head += (i == 0 ? "" : ",") + word(columns[i].name);
    finish_row(head, columns.size());
  }


  CsvWriter CsvWriter::append(const std::string &path, const std::vector<Column> &columns)
  {
    CsvWriter result(path, std::ios::app, names_of(columns), Flush::every_row);
    result.file_.seekp(0, std::ios::end);
    result.size_ = result.file_.tellp();
    return result;
  }


  void CsvWriter::row(const std::vector<double> &values)
  {
    std::string cells;
    for (std::size_t i = 0; i < values.size(); ++i)
      cells += (i == 0 ? "" : ",") + number(values[i], i);
    finish_row(cells, values.size());
  }


  void CsvWriter::row_of_cells(const std::vector<Cell> &values)
  {
    std::string cells;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const auto *const value = std::get_if<double>(&values[i]);
      cells += (i == 0 ? "" : ",") + (value != nullptr ? number(*value, i) : word(std::get<std::string>(values[i])));
    }
    finish_row(cells, values.size());
  }


  const std::string &CsvWriter::path() const
  {
    return path_;
  }


  std::string CsvWriter::number(const double value, const std::size_t column) const
  {
    if (!std::isfinite(value))
      throw ResultError("The result cannot be used: " +
                        (column < names_.size() ? names_[column] : "a value too many") +
                        " of '" + path_ + "' is no finite number. The rows before it are written.");
    char buffer[32]; // as by printf("%.10g")
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 10).ptr};
  }


  void CsvWriter::finish_row(const std::string &cells, const std::size_t n_values)
  {
    AssertThrow(n_values == names_.size(),
                dealii::ExcMessage("A row of '" + path_ + "' has " + std::to_string(n_values) + " values for " +
                                   std::to_string(names_.size()) + " columns."));
    file_ << cells << '\n';
    if (flush_ == Flush::every_row)
      flush();
  }


  void CsvWriter::flush()
  {
    file_.flush();
    if (file_)
    {
      size_ = file_.tellp();
      return;
    }
    const std::string why = std::strerror(errno);
    file_.close();
    std::error_code ignored; // half a row would be taken for a whole one
    if (ranks::first() && std::filesystem::is_regular_file(path_, ignored))
      std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(size_), ignored);
    throw SceneError("Cannot write '" + path_ + "' any further: " + why + ".");
  }
} // namespace deltaform
