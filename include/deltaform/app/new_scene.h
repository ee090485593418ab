#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Write a commented scene from a template: words are the kind ("cup"), the file, and "name=value" for what differs
   * from the template's own sizes. Fewer than two words: say what there is.
   * @throws UsageError for a kind, name or value that is none, or a file that exists
   */
  void new_scene(const std::vector<std::string> &words, std::ostream &out);
} // namespace deltaform
