#include <deltaform/increment/line_search.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  double LineSearch::search(double factor, const double work_start, const double work_end, const double share,
                            const Work &work_at)
  {
    const double smallest = .02 * factor, wanted = share * std::abs(work_start);
    double low = 0., work_low = work_start, high = factor, work_high = work_end;
    double last_good = factor, work = work_end;
    bool good = true;
    for (unsigned int k = 0; k < most_evaluations && work > wanted && factor > smallest; ++k)
    {
      ++n_evaluations_;
      const double ratio = work_low / (work_low - work_high);
      factor = std::max(smallest, low + std::clamp(ratio, .1, .9) * (high - low));
      const std::optional<double> here = work_at(factor);
      good = here.has_value();
      if (!good)
      {
        high = factor;
        continue;
      }
      last_good = factor;
      work = *here;
      if (work > 0)
      {
        high = factor;
        work_high = work;
        work_low *= .5; // Illinois
      }
      else
      {
        low = factor;
        work_low = work;
        work_high *= .5;
        if (-work > wanted)
          work = 2 * wanted; // too short: go on
      }
    }
    if (!good)
    {
      factor = last_good;
      work_at(factor);
    }
    return factor;
  }
} // namespace deltaform
