#pragma once

#include <deltaform/reports/columns.h>
#include <deltaform/stage/actors.h>

namespace deltaform
{
  /// What a stage may wait for (entry Ends when): columns of history.csv that describe the process, and some that only
  /// such a condition asks for. @param actors must live as long as the columns are used
  Columns quantities(const Actors &actors);
} // namespace deltaform
