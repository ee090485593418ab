#include "run_summary.h"

#include <deltaform/parameters/command_line.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    const char *in_words(const int status)
    {
      switch (status)
      {
      case exit_status::done:
        return "done";
      case exit_status::not_converged:
        return "not converged";
      case exit_status::promise_broken:
        return "promise penetration <= delta could not be kept";
      default:
        return "interrupted";
      }
    }
  } // namespace


  void RunSummary::begin(const Model &model, const Stage &stage)
  {
    const auto &tools = model.actors().tools;
    const bool lets_go =
      std::none_of(tools.begin(), tools.end(), [&](const auto &tool) { return tool->exists_in(stage.name); });
    if (!output_.measures.empty() && model.actors().formed_before && lets_go)
      formed_ = model.blank().fields().profile(model.committed());
  }


  void RunSummary::accepted(const AcceptedIncrement &increment)
  {
    cost_ += increment.cost;
    promise_ = std::max(promise_, increment.contact().max_penetration_over_delta);
    between_ = std::max(between_, increment.contact().max_penetration_between_nodes);
    deepest_ = std::max(deepest_, increment.contact().deepest.over_delta);
    mesh_error_.add(increment);
    remember(increment);
    remember_forces(increment.model);
    const bool last_stage = &increment.stage == &increment.model.actors().stages.back();
    if (!output_.measures.empty() && increment.ends_stage && !last_stage)
      formed_ = increment.profile();
  }


  void RunSummary::remember_forces(const Model &model)
  {
    const auto &tools = model.actors().tools;
    forces_.resize(tools.size(), 0.);
    travels_.resize(tools.size(), 0.);
    for (unsigned int i = 0; i < tools.size(); ++i)
      if (const double force = -(model.tool_forces()[i] * tools[i]->direction()); force > forces_[i])
      {
        forces_[i] = force;
        travels_[i] = model.travel(i);
      }
  }


  void RunSummary::moved(const AcceptedIncrement &increment)
  {
    if (increment.number > 0)
      remember(increment);
  }


  void RunSummary::remember(const AcceptedIncrement &increment)
  {
    any_ = true;
    time_ = increment.time;
    thinnest_ = increment.smallest_thickness();
    if (!output_.energies)
      return;
    energy_error_ = increment.energies().error();
    artificial_friction_ = increment.energies().artificial_friction();
  }


  std::vector<Measure::Result> RunSummary::measured(const Measure &measure, const Model &model) const
  {
    const Table now = model.blank().fields().profile(model.committed());
    return measure.of(now, formed_.rows.empty() ? now : formed_);
  }


  std::vector<std::string> RunSummary::missing(const Model &model) const
  {
    std::vector<std::string> result;
    for (const auto &measure : output_.measures)
      if (measured(*measure, model).empty())
        result.push_back("nothing to measure: Output/Measures/" + measure->name() + ": " + measure->needs() + ".");
    return result;
  }


  std::string RunSummary::json(const Model &model, const RunOutcome &outcome, const std::string &title,
                               const std::string &units_label, const double seconds) const
  {
    nlohmann::ordered_json summary{{"title", title},
                                   {"units", units_label},
                                   {"version", DELTAFORM_VERSION},
                                   {"exit_status", outcome.exit_status},
                                   {"outcome", in_words(outcome.exit_status)}};
    if (!outcome.message.empty())
      summary["message"] = outcome.message;
    summary["warnings"] = outcome.warnings;
    summary["unknowns"] = model.committed().size();
    summary["increments"] = outcome.increments;
    summary["newton_iterations"] = outcome.iterations;
    summary["rejected_iterations"] = cost_.rejected_iterations;
    summary["penalty_rounds"] = cost_.rounds;
    summary["penalty_iterations"] = cost_.correction_iterations;
    summary["cutbacks"] = cost_.cutbacks;
    summary["time"] = time_;
    summary["tools"] = nlohmann::ordered_json::object();
    for (unsigned int i = 0; any_ && i < model.actors().tools.size(); ++i)
      summary["tools"][model.actors().tools[i]->name()] = {{"travel", model.travel(i)},
                                                           {"force_z", model.tool_forces()[i][1]},
                                                           {"force_r", model.tool_forces()[i][0]},
                                                           {"max_force", i < forces_.size() ? forces_[i] : 0.},
                                                           {"max_force_travel", i < forces_.size() ? travels_[i] : 0.}};
    for (const auto &measure : output_.measures)
    {
      auto &results = summary["measures"][measure->name()] = nlohmann::ordered_json::object();
      for (const auto &[name, value] : measured(*measure, model))
        results[name] = value;
    }
    summary["min_thickness"] = thinnest_;
    summary["max_penetration_over_delta"] = promise_;
    summary["max_penetration_between_nodes"] = between_;
    summary["max_penetration_between_nodes_over_delta"] = deepest_;
    if (output_.energies)
    {
      summary["energy_error"] = energy_error_;
      summary["artificial_friction"] = artificial_friction_;
    }
    if (mesh_error_.share() >= 0.)
      summary["mesh_error"] = mesh_error_.share();
    summary["seconds"] = seconds;
    // Names of scenes may be in another encoding than UTF-8: their bytes must not spoil the file.
    return summary.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }


  std::string RunSummary::last_line(const Model &model, const RunOutcome &outcome, const double seconds) const
  {
    std::string line;
    if (const auto main = output_.main_tool; main != invalid_index && any_)
      line = fmt::format("{}: travel {:.4g}, force {:.6g}; thinnest {:.4g}; ",
                         model.actors().tools[main]->name(),
                         model.travel(main),
                         model.tool_forces()[main][1],
                         thinnest_);
    line += fmt::format("{} increments, {} Newton iterations, {:.2f} s",
                        outcome.increments,
                        outcome.iterations,
                        seconds);
    if (!model.actors().keeps_promise())
      return line;
    line += fmt::format("; max penetration/delta {:.3f}", promise_);
    constexpr double worth_a_word = 1.5;
    if (deepest_ > worth_a_word)
      line += fmt::format(", between the points {:.3g}", deepest_);
    return line;
  }
} // namespace deltaform
