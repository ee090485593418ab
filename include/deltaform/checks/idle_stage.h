#pragma once

#include <deltaform/stage/actors.h>

namespace deltaform
{
  /// Does a tool, a support or a load do anything in @p stage, or is anything let go? Metal that depends on the time is
  /// not looked at. @param before the stage before; null: none
  bool changes_anything(const Actors &actors, const Stage &stage, const Stage *before);
} // namespace deltaform
