#pragma once

#include <deltaform/stage/actors.h>

#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Motions of the whole undeformed blank at the start of a stage that neither supports nor contact without friction
   * prevent, in words: "along z", "along x", "a rotation". Contact prevents a motion if it closes or opens the gap of a
   * node that lies on a tool, or would be the first to; a tool that is driven by a force follows along its direction.
   * What a tool of a later stage meets is not known before the run: it is taken to prevent every motion.
   */
  std::vector<std::string> free_rigid_motions(const Actors &actors, const Stage &stage);
} // namespace deltaform
