#pragma once

#include <string>
#include <vector>

namespace deltaform
{
  /// Small operations on the text of scenes and messages.
  namespace text
  {
    /// @p text without white space at its ends.
    std::string trim(const std::string &text);

    /// @p text, trimmed, without a pair of equal quotes (' or ") around the whole of it, as values are often copied
    /// from a page.
    std::string unquoted(const std::string &text);

    /// The trimmed pieces of @p text between separators that stand outside of parentheses; of blank text, none.
    std::vector<std::string> split(const std::string &text, char separator);

    /// @p text with escapes in place of what a terminal would obey or could not show: control characters but for
    /// newline and tab, and bytes that are no UTF-8, as \x1b.
    std::string printable(const std::string &text);

    /// "a, b, c".
    std::string join(const std::vector<std::string> &pieces, const std::string &separator);

    /// The shortest decimal number that reads back as exactly @p value.
    std::string format(double value);

    /// Four significant digits, for places and depths in messages.
    std::string rounded(double value);

    /// The name of a tool, support or load as columns carry it: underscores in place of blanks.
    std::string column_name(const std::string &name);

    /// Number of insertions, deletions, replacements and swaps of neighbours that turn a into b; capitals do not count.
    unsigned int edit_distance(const std::string &a, const std::string &b);

    /// The one of @p candidates closest to @p name in edit distance; empty if there is none.
    std::string nearest(const std::string &name, const std::vector<std::string> &candidates);

    /// Are the two close enough for one to be a misspelling of the other?
    bool similar(const std::string &a, const std::string &b);
  } // namespace text
} // namespace deltaform
