#pragma once

#include <deltaform/parameters/command_line.h>

#include <iosfwd>

namespace deltaform
{
  class FormingLimit;

  /// Write the forming limit of a scene into its folder of results, fld.csv and fld.svg. @return the exit status
  int write_forming_limit(const CommandLine &command);

  /// Draw a forming limit diagram: minor strain to the right, major strain upwards.
  void draw_forming_limit(const FormingLimit &limit, std::ostream &out);
} // namespace deltaform
