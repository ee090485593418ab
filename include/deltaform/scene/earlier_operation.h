#pragma once

#include <deltaform/io/keyed_arrays.h>

#include <string>

namespace deltaform
{
  /// What the run in a folder of results has formed its blank to, from the state that was saved last: see
  /// Blank::formed(). @throws SceneError if there is no such state, or it cannot be read
  KeyedArrays formed_blank(const std::string &folder);
} // namespace deltaform
