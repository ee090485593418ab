// Which direct solver is the faster one: measured in doc/performance.md, "Which solver".
#include <deltaform/process/ranks.h>
#include <deltaform/solver/linear_solver.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// Levels of neighbours of neighbours from @p start, all marked: the last unknown that is met, and the most that a
    /// level has.
    std::pair<DofIndex, std::size_t> sweep(const dealii::DynamicSparsityPattern &pattern,
                                           const DofIndex start,
                                           const unsigned char mark,
                                           std::vector<unsigned char> &seen)
    {
      std::pair<DofIndex, std::size_t> result{start, 0};
      std::vector<DofIndex> level{start}, next;
      seen[start] = mark;
      while (!level.empty())
      {
        result = {level.back(), std::max(result.second, level.size())};
        next.clear();
        for (const auto row : level)
          for (auto column = pattern.begin(row); column != pattern.end(row); ++column)
            if (seen[column->column()] != mark)
            {
              seen[column->column()] = mark;
              next.push_back(column->column());
            }
        level.swap(next);
      }
      return result;
    }
  } // namespace


  std::size_t front_width(const dealii::DynamicSparsityPattern &pattern)
  {
    const DofIndex n = pattern.n_rows();
    if (ranks::count() > 1)
      return static_cast<std::size_t>(2. * std::sqrt(2. * n));
    std::size_t widest = 0;
    std::vector<unsigned char> seen(n, 0);
    for (DofIndex i = 0; i < n; ++i)
      if (seen[i] == 0)
        widest = std::max(widest, sweep(pattern, sweep(pattern, i, 1, seen).first, 2, seen).second);
    return widest;
  }


  void LinearSolverSettings::choose(const std::size_t n, const std::size_t width)
  {
    constexpr std::size_t small = 5000, narrow = 50;
    if (!automatic)
      return;
    name = n < small || width < narrow ? "klu" : "mumps";
    method = method_called(name);
  }
} // namespace deltaform
