#pragma once

#include <deltaform/materials/forming_limit.h>

#include <optional>

namespace deltaform
{
  /// The sheet of Marciniak and Kuczynski: one with a straight groove, in which the metal strains ahead until it does
  /// so alone.
  struct GroovedSheet
  {
    double thickness_ratio = .99; ///< of the groove over the sheet, at the start
    double angle = 0.; ///< rad, between the groove's normal and the direction of the major strain, at the start

    /**
     * Strains of the sheet when the groove strains ten times as fast, on a path with d minor = @p ratio d major.
     * @return nothing if that does not happen before the groove has strained by 5, or if the law gives no stress
     */
    std::optional<FormingLimit::Point> limit(const Material &law, double ratio) const;

    /// The same for the groove whose angle gives the least: across the major strain from plane strain to equal
    /// strains, else turned.
    std::optional<FormingLimit::Point> least_limit(const Material &law, double ratio) const;
  };
} // namespace deltaform
