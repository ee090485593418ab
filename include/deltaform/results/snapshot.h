#pragma once

#include <deltaform/io/csv_writer.h>
#include <deltaform/io/table.h>
#include <deltaform/results/output_settings.h>

#include <string>
#include <vector>

namespace deltaform
{
  class AcceptedIncrement;
  class Model;

  /// Columns of numbers and words; the units are dimensions.
  struct MixedTable
  {
    std::vector<CsvWriter::Column> columns;
    std::vector<std::vector<CsvWriter::Cell>> rows;
  };

  /// A state of a run as tables; their columns: doc/output.md.
  struct Snapshot
  {
    std::string stage;
    double time = 0.;
    double travel = 0.; ///< of the main tool; the time where there is none
    Table profile; ///< along the blank
    MixedTable contact; ///< a row per touching contact point
    MixedTable outlines; ///< of the tools: name, r, z
  };

  Snapshot take_snapshot(const Model &model, const OutputSettings &output, const std::string &stage, double time);

  /// Are tables wanted of the state at the end of @p increment?
  bool asks_for_tables(const OutputSettings &output, const AcceptedIncrement &increment);
} // namespace deltaform
