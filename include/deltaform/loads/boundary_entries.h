#pragma once

#include <deltaform/blanks/blank.h>

#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /// @name Entries that supports and loads have in common
  ///@{
  Component read_component(Section &section);

  std::string read_boundary(Section &section, const Boundary &boundary);

  /// @throws SceneError if the boundary has no unknown of this component
  void check_dofs(Section &section, const std::string &boundary, const std::vector<DofIndex> &dofs);
  ///@}

  /// Does a list of stages (empty: all) hold a stage?
  bool listed(const std::vector<std::string> &stages, const std::string &stage);
} // namespace deltaform
