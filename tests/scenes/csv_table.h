#pragma once

#include <string>
#include <vector>

/// A table that deltaform has written: numbers by column and row. Text reads as NaN.
struct CsvTable
{
  /// Read a file: lines that start with '#' are comments, the first other one names the columns. @throws
  /// std::runtime_error
  static CsvTable read(const std::string &file_name);

  /// Values of a column. @throws std::runtime_error if there is none, naming those that there are.
  const std::vector<double> &column(const std::string &name) const;

  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
};

/// Value of a polygon y(x) at a place, the first piece that reaches it. @throws std::runtime_error outside
double interpolate(const std::vector<double> &x, const std::vector<double> &y, double place);
