#include "csv_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace
{
  std::vector<std::string> cells_of(const std::string &line)
  {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    std::string cell;
    while (std::getline(stream, cell, ','))
      cells.push_back(cell);
    return cells;
  }


  double number(const std::string &cell)
  {
    char *end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    return end != cell.c_str() && *end == '\0' ? value : std::numeric_limits<double>::quiet_NaN();
  }
} // namespace


CsvTable
CsvTable::read(const std::string &file_name)
{
  std::ifstream file(file_name);
  if (!file)
    throw std::runtime_error("there is no file " + file_name);
  CsvTable table;
  std::string line;
  while (std::getline(file, line))
  {
    if (line.empty() || line[0] == '#')
      continue;
    const auto cells = cells_of(line);
    if (table.names.empty())
    {
      table.names = cells;
      table.columns.resize(cells.size());
      continue;
    }
    if (cells.size() != table.names.size())
      throw std::runtime_error(file_name + ": a row has " + std::to_string(cells.size()) + " cells instead of " +
                               std::to_string(table.names.size()));
    for (unsigned int i = 0; i < cells.size(); ++i)
      table.columns[i].push_back(number(cells[i]));
  }
  if (table.columns.empty() || table.columns.front().empty())
    throw std::runtime_error(file_name + " has no rows");
  return table;
}


const std::vector<double> &
CsvTable::column(const std::string &name) const
{
  const auto place = std::find(names.begin(), names.end(), name);
  if (place == names.end())
  {
    std::string all;
    for (const auto &known : names)
      all += " " + known;
    throw std::runtime_error("there is no column '" + name + "'; there are" + all);
  }
  return columns[place - names.begin()];
}


double
interpolate(const std::vector<double> &x, const std::vector<double> &y, const double place)
{
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const double slack = 1e-9 * std::max(std::abs(*low), std::abs(*high));
  for (unsigned int i = 0; i < x.size(); ++i)
  {
    if (std::abs(x[i] - place) <= slack)
      return y[i];
    if (i + 1 < x.size() && (x[i] - place) * (x[i + 1] - place) < 0 && std::abs(x[i + 1] - place) > slack)
      return y[i] + (y[i + 1] - y[i]) * (place - x[i]) / (x[i + 1] - x[i]);
  }
  std::ostringstream message;
  message << "nothing is known at " << place << ", only from " << *low << " to " << *high;
  throw std::runtime_error(message.str());
}
