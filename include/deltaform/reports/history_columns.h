#pragma once

#include <deltaform/model/model.h>
#include <deltaform/reports/columns.h>

#include <iosfwd>

namespace deltaform
{
  class ConditionReport;

  /// What a run reports of every increment, a column of history.csv each. @param energies are they asked for?
  /// @param condition must live as long as the columns are used; null: nobody asks for condition numbers
  Columns history_columns(const Model &model, bool energies, const ConditionReport *condition);

  /// The page on the columns of history.csv, in Markdown.
  void print_columns(std::ostream &out);
} // namespace deltaform
