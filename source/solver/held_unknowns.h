#pragma once
// Unknowns to hold so that no rigid motion is free; private to the solver.
#include <deltaform/assembly/types.h>

#include <optional>
#include <vector>

namespace deltaform
{
  /**
   * Unknowns to hold so that no motion is free: as many of @p candidates as there are combinations of @p motions that
   * leave all prescribed unknowns where they are, chosen for their independence.
   * @return nothing if the candidates do not do
   */
  std::optional<std::vector<DofIndex>> held_unknowns(const std::vector<Vector> &motions,
                                                     const std::vector<DofIndex> &candidates,
                                                     const std::vector<bool> &prescribed);
} // namespace deltaform
