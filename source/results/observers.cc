#include <deltaform/model/forming_problem.h>
#include <deltaform/model/reported_columns.h>
#include <deltaform/results/condition_numbers.h>
#include <deltaform/results/observers.h>

#include <utility>

namespace deltaform
{
  std::vector<std::unique_ptr<Observer>> make_observers(const FormingProblem &model, const OutputSettings &output,
                                                        ResultsFolder &folder, const Checkpoint *const start)
  {
    std::vector<std::unique_ptr<Observer>> result;
    Columns columns;
    describe_increment(columns);
    describe_tools(model, columns);
    describe_cost(columns);
    describe_contact(columns);
    describe_thickness(columns);
    if (output.condition_every > 0)
    {
      auto condition = std::make_unique<ConditionReport>(output.condition_every, output.condition_method, folder);
      condition->describe(columns);
      result.push_back(std::move(condition));
    }
    if (model.linear_solver().iterative())
      describe_linear_solver(columns);
    if (model.blank().refinement() != nullptr)
      describe_mesh(columns);
    if (output.energies)
      describe_energies(columns);
    describe_supports(model, columns);
    describe_loads(model, columns);
    describe_balance(columns);

    result.push_back(make_history_observer(folder, std::move(columns), start));
    result.push_back(make_progress_observer(folder, output));
    result.push_back(make_table_observer(folder, output));
    result.push_back(make_picture_observer(folder, output));
    result.push_back(make_summary_observer(folder, output));
    result.push_back(make_checkpoint_observer(folder, output));
    return result;
  }
} // namespace deltaform
