// Which linear solver is the faster one: measured in doc/distributed.md, "Which solver".
#include <deltaform/base/ranks.h>
#include <deltaform/solver/linear_solver.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /**
     * How many unknowns a front has that sweeps over the mesh, from neighbours to neighbours (the width of the level
     * structure, Gibbs, Poole, Stockmeyer (1976), SIAM J. Numer. Anal. 13, 236): a few times the unknowns across a
     * strip, however long it is.
     */
    std::size_t front_width(const dealii::DynamicSparsityPattern &pattern)
    {
      std::size_t widest = 0;
      std::vector<unsigned int> seen(pattern.n_rows(), 0);
      std::vector<DofIndex> level, next;
      const auto sweep = [&](const DofIndex start, const unsigned int mark)
      {
        DofIndex last     = start;
        std::size_t width = 0;
        level.assign(1, start);
        seen[start] = mark;
        while (!level.empty())
        {
          width = std::max(width, level.size());
          last  = level.back();
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
        return std::make_pair(last, width);
      };
      for (DofIndex i = 0; i < pattern.n_rows(); ++i)
        if (seen[i] == 0)
          widest = std::max(widest, sweep(sweep(i, 1).first, 2).second); // from an end of the body
      return widest;
    }
  } // namespace


  void LinearSolverSettings::choose(const dealii::DynamicSparsityPattern &pattern,
                                    const bool constant,
                                    const bool symmetric)
  {
    if (!automatic)
      return;
    constexpr std::size_t small = 10000, wide = 200, large = 500000;
    const std::size_t n = pattern.n_rows();
    // A process knows the couplings of its own rows only.
    const bool block = n > small && (ranks::count() > 1 || front_width(pattern) > wide);
    name             = !block ? "klu" : n > large && constant && symmetric ? "cg amg" : "mumps";
  }
} // namespace deltaform
