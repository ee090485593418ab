#pragma once

#include <optional>
#include <string>

namespace deltaform
{
  /**
   * Remove from a folder the tables and pictures that an earlier run of this program has left there, so that they are
   * not taken for those of a new one: profile_*.csv, contact_*.csv and tools_*.csv whose head names the program, and
   * what scene.pvd lists under the names of this program's pictures, with scene.pvd. Other files stay, also where a
   * name is similar.
   * @return how many files are gone. No folder, or nothing to remove, is no error.
   */
  unsigned int remove_earlier_results(const std::string &folder);

  /// Remove the drafts (*.part of files of this program) of a run that was killed while it wrote. @return how many
  unsigned int remove_drafts(const std::string &folder);

  /// The exit status in summary.json of an earlier run; none if it has not left one, because it was killed or still
  /// runs.
  std::optional<int> earlier_exit_status(const std::string &folder);
} // namespace deltaform
