#pragma once

#include <cstddef>

namespace deltaform
{
  /// What a scene may have at most: far more than any process needs, and little enough for memory and patience. The
  /// page doc/stress.md lists them.
  namespace ceilings
  {
    constexpr std::size_t scene_bytes = 16u << 20; ///< of a scene with all that it includes
    constexpr std::size_t includes = 1000; ///< files read in all, one that is read twice counts twice
    constexpr std::size_t include_depth = 50; ///< a file that includes one that includes ...
    constexpr std::size_t nesting = 20; ///< subsections in one another
    constexpr std::size_t entries = 10000; ///< entries and subsections
    constexpr std::size_t name_bytes = 200; ///< of an entry or a subsection
    constexpr std::size_t expression_bytes = 10000; ///< of a formula; tables may be longer
    constexpr std::size_t complaints = 20; ///< that are said about one scene
    constexpr std::size_t mesh_bytes = 1u << 30; ///< of a mesh file
    constexpr std::size_t sweep_runs = 10000; ///< of a sweep
    constexpr double length_ratio = 1e12; ///< between the largest length and the smallest size of a scene
    constexpr double cell_aspect = 1e6; ///< longest edge of a cell over its shortest
    constexpr double magnitude = 1e60; ///< of a number with a unit
    constexpr double smallest_size = 1e-60; ///< of one that is positive
  } // namespace ceilings
} // namespace deltaform
