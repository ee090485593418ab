#pragma once

#include <deltaform/parameters/declared_section.h>

#include <functional>
#include <iosfwd>
#include <string>

namespace deltaform
{
  /// The text of an entry's value.
  using ValueOf = std::function<std::string(const SectionPath &, const Declaration &)>;

  /// @p section as a scene: every entry with its value, and unit, range and sentence as a comment.
  void print_prm(std::ostream &out, const DeclaredSection &section, const SectionPath &path, const ValueOf &value);

  /// A table per section from @p root on: entry, default, unit, allowed values, sentence.
  void print_markdown(std::ostream &out, const DeclaredSection &root);
} // namespace deltaform
