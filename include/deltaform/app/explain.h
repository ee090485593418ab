#pragma once

#include <iosfwd>
#include <string>

namespace deltaform
{
  /**
   * Print what is known of an entry: unit, range, default and meaning, once for each choice that it belongs to.
   * @param entry "Tools/punch/Friction coefficient", or a name without its section, of which all are printed
   * @throws UsageError naming the nearest entry if there is no such one
   */
  void explain(const std::string &entry, std::ostream &out);
} // namespace deltaform
