#pragma once

#include <deltaform/io/table.h>
#include <deltaform/parameters/registry.h>

#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /**
   * What a gauge would measure on the finished part: radii, angles, lengths of the section. Each kind is a
   * file in source/measures that registers itself under the name that the entry Kind gives.
   */
  class Measure
  {
  public:
    /// A number with its name in summary.json; angles in degrees, lengths in the scene's unit.
    using Result = std::pair<std::string, double>;

    explicit Measure(std::string name)
      : name_(std::move(name))
    {
    }

    virtual ~Measure() = default;

    const std::string &name() const
    {
      return name_;
    }

    /**
     * @param now    profile of the blank at the end of the run, see Fields::profile()
     * @param before the same at the end of the last stage but one; of a run of one stage the same as
     *   @p now or, where it lets go of what an earlier operation has formed, as that left it
     * @return nothing where the part has no such feature
     */
    virtual std::vector<Result> of(const Table &now, const Table &before) const = 0;

    /// What the part must have, said where of() finds nothing.
    virtual std::string needs() const = 0;

  private:
    std::string name_;
  };

  using MeasureRegistry = Registry<Measure>;
} // namespace deltaform
