#pragma once

#include <deltaform/materials/material.h>
#include <deltaform/parameters/registry.h>

#include <string>
#include <vector>

namespace deltaform
{
  /**
   * A forming limit curve: the major principal strain in the plane of a sheet (logarithmic) at which it necks, against
   * the minor one. Straight between the points; constant beyond the last one. Before the first one it goes on straight
   * if it rises to the left (metal that thickens does not neck), and is constant else.
   */
  class FormingLimit
  {
  public:
    struct Point
    {
      double minor, major; ///< strains (1)
    };

    /// @throws std::invalid_argument, with a sentence, if the points are no function of the minor strain that is
    /// positive and no less than the minor strain
    explicit FormingLimit(std::vector<Point> points);

    const std::vector<Point> &points() const
    {
      return points_;
    }

    /// Limit of the major strain at a minor one.
    double major(double minor) const;

    /// Major strain at which a path with d minor = @p ratio d major from the origin meets the curve; infinite if it
    /// never does. @param ratio at most 1
    double along(double ratio) const;

  private:
    std::vector<Point> points_;
  };

  /// Where forming limits come from, by name; some are computed from the law of the metal.
  using FormingLimits = Registry<FormingLimit, const Material &>;

  /// The limit that the section Limits/forming limit of a scene names, of the metal @p law.
  std::unique_ptr<FormingLimit> read_forming_limit(const Section &scene, const Material &law);
} // namespace deltaform
