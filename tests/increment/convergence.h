#pragma once
// The observed order of a Newton iteration.
#include <deltaform/increment/newton.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/section.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace deltaform
{
  namespace testing
  {
    inline NewtonSettings newton_settings(const std::vector<std::string> &entries)
    {
      ParameterTree tree = ParameterTree::parse("", "test", entries);
      Section section = tree.root();
      return NewtonSettings(section);
    }

    /// Every unknown is coupled with every other.
    inline dealii::DynamicSparsityPattern full_pattern(const unsigned int n)
    {
      dealii::DynamicSparsityPattern result(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          result.add(i, j);
      return result;
    }

    /**
     * Order p of r_k+1 = C r_k^p from three residuals that decrease, all above @p smallest (round-off): the best of the
     * last three triples, because the last residual may already feel the round-off. Not a number if there is none.
     */
    inline double observed_order(std::vector<double> residuals, const double smallest)
    {
      double order = std::numeric_limits<double>::quiet_NaN();
      while (!residuals.empty() && !(residuals.back() > smallest))
        residuals.pop_back();
      for (unsigned int triple = 0; triple < 3 && residuals.size() >= 3; ++triple, residuals.pop_back())
      {
        const double *const r = &residuals[residuals.size() - 3];
        if (r[2] < r[1] && r[1] < r[0])
          order = std::fmax(order, std::log(r[2] / r[1]) / std::log(r[1] / r[0]));
      }
      return order;
    }

    inline std::string listed_residuals(const std::vector<double> &residuals)
    {
      std::ostringstream text;
      for (const double residual : residuals)
        text << ' ' << residual;
      return text.str();
    }
  } // namespace testing
} // namespace deltaform
