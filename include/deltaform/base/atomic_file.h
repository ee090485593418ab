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
} // namespace deltaform
