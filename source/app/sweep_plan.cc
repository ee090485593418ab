#include "sweep_plan.h"

#include <fmt/core.h>

#include <cmath>
#include <numeric>
#include <random>

namespace deltaform
{
  namespace
  {
    /// All combinations; the values of the last variation change fastest.
    std::vector<SweepRun> combinations(const std::vector<Variation> &variations)
    {
      std::vector<SweepRun> runs(1);
      for (const auto &variation : variations)
      {
        std::vector<SweepRun> longer;
        for (const auto &run : runs)
          for (const auto &value : variation.values)
          {
            longer.push_back(run);
            longer.back().values.push_back(value);
          }
        runs = std::move(longer);
      }
      return runs;
    }


    /// Numbers in [0, 1) that are the same with every standard library, which std::uniform_real_distribution's are not.
    class Uniform
    {
    public:
      explicit Uniform(const unsigned int seed)
        : engine_(seed)
      {
      }

      double operator()()
      {
        return static_cast<double>(engine_() >> 11) * 0x1p-53;
      }

    private:
      std::mt19937_64 engine_;
    };


    /// The value at a share in [0, 1) of a variation.
    std::string value_at(const Variation &variation, const double share)
    {
      if (variation.interval)
        return fmt::format("{:.6g}", variation.first + share * (variation.last - variation.first));
      const double n = static_cast<double>(variation.values.size());
      return variation.values[static_cast<std::size_t>(std::floor(share * n))];
    }


    /**
     * A Latin hypercube: each variation is cut into as many parts as there are samples, and every part has one sample.
     * M.D. McKay, R.J. Beckman, W.J. Conover, Technometrics 21 (1979) 239. A list of values is one of equal shares.
     */
    std::vector<SweepRun> latin_hypercube(const std::vector<Variation> &variations, const std::size_t n,
                                          const unsigned int seed)
    {
      Uniform uniform(seed);
      std::vector<SweepRun> runs(n);
      std::vector<std::size_t> part(n);
      for (const auto &variation : variations)
      {
        std::iota(part.begin(), part.end(), std::size_t(0));
        for (std::size_t i = n; i-- > 1;)
          std::swap(part[i], part[static_cast<std::size_t>(uniform() * static_cast<double>(i + 1))]);
        for (std::size_t i = 0; i < n; ++i)
          runs[i].values.push_back(
            value_at(variation, (static_cast<double>(part[i]) + uniform()) / static_cast<double>(n)));
      }
      return runs;
    }
  } // namespace


  std::vector<SweepRun> plan_sweep(const CommandLine &command)
  {
    return command.samples > 0 ? latin_hypercube(command.variations, command.samples, command.seed)
                               : combinations(command.variations);
  }


  std::vector<std::string> assignments(const CommandLine &command, const SweepRun &run)
  {
    std::vector<std::string> result = command.sets;
    for (std::size_t i = 0; i < run.values.size(); ++i)
      result.push_back(command.variations[i].entry + "=" + run.values[i]);
    return result;
  }
} // namespace deltaform
