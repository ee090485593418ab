#include <deltaform/analysis/analysis.h>
#include <deltaform/app/run_in_memory.h>
#include <deltaform/reports/condition_numbers.h>
#include <deltaform/reports/history_columns.h>
#include <deltaform/results/observers.h>
#include <deltaform/scene/earlier_operation.h>
#include <deltaform/scene/input_warnings.h>
#include <deltaform/scene/scene.h>

#include <sstream>

namespace deltaform
{
  RunRecord run_in_memory(ParameterTree &tree, const Keep keep, const AfterIncrement &after)
  {
    Timers timers;
    std::ostringstream said;
    Journal journal(Journal::Console::plain, said, said);
    Scene scene(tree);
    for (const auto &note : scene.notes)
      journal.note(note);
    Analysis analysis(scene.actors, scene.analysis_settings(), journal, timers);
    RunRecord record;
    record.title = scene.title;
    record.units = scene.units;
    record.axisymmetric = scene.actors.blank->axisymmetric();
    auto condition = make_condition_report(*scene.output, journal, timers);
    auto columns = history_columns(analysis.model(), scene.output->energies, condition.get());
    if (condition != nullptr)
      analysis.add(std::move(condition));
    analysis.add(
      make_recorder(record, std::move(columns), *scene.output, keep, [&timers]() { return timers.total(); }));
    if (!scene.start_from.empty())
      analysis.start_from(formed_blank(scene));
    analysis.warn(input_warnings(scene));
    analysis.begin();
    for (bool more = true; more;)
    {
      const std::size_t n_before = record.history.size();
      more = analysis.advance();
      if (after && record.history.size() > n_before)
        after(record.columns, record.history.back());
    }
    analysis.end();
    record.log = said.str();
    return record;
  }
} // namespace deltaform
