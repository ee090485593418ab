#pragma once

#include <string>
#include <vector>

/// "# CHECK history.csv punch_force_z at punch_travel=0.6: 1.23 within 1e-3 relative (source)"
struct Check
{
  enum class Kind : unsigned char
  {
    within,
    below,
    above
  };

  std::string text;
  std::string file, column;
  std::string select; ///< first, last, max, min, maxabs or at
  std::string at_column; ///< of 'at'
  double at = 0;
  Kind kind = Kind::within;
  double reference = 0, tolerance = 0;
  bool relative = false;
};

/// "# COMPARE history.csv columns a,b over time with {work}/../other/history.csv tolerance 1e-6 relative"; relative to
/// the largest of a column. The other table is what another scene has left behind (its test comes first, see
/// CMakeLists.txt), or one in reference/ that has its origin elsewhere: nothing keeps numbers of the program itself.
struct Comparison
{
  std::string text;
  std::string file, over, reference; ///< over: empty compares row by row
  std::vector<std::string> columns;
  double tolerance = 0;
  bool relative = false;
};

/**
 * What a test scene expects, in its comments:
 *   EXIT n          status of the program (0 by default)
 *   COMMAND a b c   its arguments, instead of '{scene} --quiet --output {work}'
 *   MESSAGE text    part of what it prints; may be repeated
 *   FILE name       a table it has to leave behind, with at least one row
 *   CHECK, COMPARE  see above
 * {scene} is the file, {work} the folder of results, {here} 'file:line' of the line that is marked with '# <-- here'.
 */
struct Directives
{
  /// @throws std::runtime_error for a line that cannot be understood, or if nothing is expected
  static Directives read(const std::string &scene, const std::string &work);

  int exit_status = 0;
  std::string command;
  std::vector<std::string> messages, files;
  std::vector<Check> checks;
  std::vector<Comparison> comparisons;
};
