#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace deltaform
{
  /**
   * Write a whole file so that readers, and whoever kills the program, only ever see the old or the new content: the
   * text goes to a file beside it, which then takes its name.
   * @throws SceneError if the file cannot be written, naming it and the reason.
   */
  void write_file_atomically(const std::string &path, const std::function<void(std::ostream &)> &write);

  /// The same for what opens its file itself: @p write gets the name of the file beside it. On the first process only.
  /// @throws SceneError if the file cannot take its name.
  void replace_file(const std::string &path, const std::function<void(const std::string &draft)> &write);
} // namespace deltaform
