#pragma once

#include <deltaform/stage/actors.h>

#include <optional>
#include <string>

namespace deltaform
{
  /// What is wrong with the place of a tool at the moment it comes.
  struct Misplacement
  {
    std::string entry; ///< of the tool's section: which one to change
    std::string message; ///< which tool, where, how deep, and what to do
  };

  /**
   * Does a tool that comes now overlap the blank, or is its profile walked so that the blank lies inside?
   * @param q state of the blank
   * @param travel of the tool
   * @param tolerance overlap (length) that contact copes with by itself
   */
  std::optional<Misplacement> find_misplacement(const Blank &blank, const ContactInterface &interface, const Vector &q,
                                                double travel, double tolerance);

  /// The same in words for the tools that come with the stage @p next, at the end of the one before (empty: none) and
  /// of the unknowns @p q; empty: nothing.
  std::string misplaced_tool(const Actors &actors, const std::string &before, const Vector &q, const Stage &next);
} // namespace deltaform
