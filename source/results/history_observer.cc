// history.csv: a row per increment, on disk at once.
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/results/history.h>
#include <deltaform/results/observers.h>

#include <optional>
#include <utility>

namespace deltaform
{
  namespace
  {
    std::vector<CsvWriter::Column> with_units(const Columns &columns, const Units &units)
    {
      std::vector<CsvWriter::Column> result;
      for (const auto &column : columns.columns())
        result.push_back({column.name, units.of(column.dimension)});
      return result;
    }

    class HistoryObserver : public Observer
    {
    public:
      HistoryObserver(ResultsFolder &folder, Columns columns, const std::optional<History::Resumption> &resumption)
        : folder_(folder), columns_(std::move(columns)),
          history_(folder.path("history.csv"), folder.comments(), with_units(columns_, folder.units()), resumption)
      {
      }

      void begin(const Model & /*model*/, const Stage & /*stage*/) override
      {
        history_.open();
      }

      void resumed(const AcceptedIncrement & /*increment*/) override
      {
        history_.open();
        if (!history_.left_out().empty())
          folder_.journal().note("history.csv keeps its columns, so that these are not written: " +
                                 text::join(history_.left_out(), ", "));
      }

      void accepted(const AcceptedIncrement &increment) override
      {
        history_.append(columns_.row(increment));
      }

    private:
      ResultsFolder &folder_;
      Columns columns_;
      History history_;
    };
  } // namespace


  std::unique_ptr<Observer> make_history_observer(ResultsFolder &folder, Columns columns,
                                                  const std::optional<History::Resumption> &resumption)
  {
    return std::make_unique<HistoryObserver>(folder, std::move(columns), resumption);
  }
} // namespace deltaform
