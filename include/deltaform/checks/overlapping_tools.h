#pragma once

#include <deltaform/stage/actors.h>

#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Tools of opposite sides, both with a motion, that run into each other while both take part in a stage. The blank
   * between them would have no room. Looked for at equal distances in time, near the blank: where its
   * coordinates r are (enlarged by its thickness), on every height.
   * @return one sentence per pair of tools and stage: both names, time and place of the first overlap found, its depth
   * (length), and what to change
   */
  std::vector<std::string> overlapping_tools(const Actors &actors);
} // namespace deltaform
