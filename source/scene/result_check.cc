#include <deltaform/base/command_line.h>
#include <deltaform/base/percent.h>
#include <deltaform/base/text.h>
#include <deltaform/scene/result_check.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    // What is more than this makes a result doubtful.
    constexpr double largest_energy_error = .02, largest_imbalance = 1e-3, thinnest_ratio = 1. / 3.;
    constexpr double largest_friction_error = .05, least_friction = .01;

    constexpr const char *remedy_of_ironing =
      ". Model the blank as a solid of degree 2 with two elements through the thickness (Blank/Kind = solid), or give "
      "the tools more clearance";
  } // namespace


  ResultCheck::ResultCheck(const Actors &actors)
    : actors_(actors), touched_(actors.tools.size(), false), thinnest_(actors.blank->initial_thickness())
  {
  }


  void ResultCheck::observe(const Stage &stage, const HistoryRow &row)
  {
    auto sections = actors_.blank->sections();
    ironing_.observe(sections);
    necking_.observe(std::move(sections));
    for (unsigned int i = 0; i < actors_.pairs.size(); ++i)
      if (!touched_[i] && actors_.tools[i]->exists_in(stage.name))
        touched_[i] = actors_.pairs[i]->n_touching() > 0;
    if (row.balance_error > worst_balance_)
    {
      worst_balance_ = row.balance_error;
      balance_time_ = row.time;
    }
    last_energy_error_ = row.energy_error;
    friction_ = row.friction_energy;
    friction_error_ = row.friction_error;
    work_ = std::max(row.tool_work, row.load_work);
    thinnest_ = std::min(thinnest_, row.min_thickness);
  }


  void ResultCheck::snapped(const HistoryRow &row, const double rotation)
  {
    ++n_snaps_;
    if (rotation <= largest_turn_)
      return;
    largest_turn_ = rotation;
    snap_time_ = row.time;
  }


  std::string ResultCheck::likely_cause() const
  {
    if (const std::string &ironed = ironing_.suspicion(); !ironed.empty())
      return ironed + remedy_of_ironing;
    return necking_.finding();
  }


  std::string ResultCheck::failure(const Stage &stage)
  {
    if (const std::string ironed = ironing_.finding(); !ironed.empty())
      return ironed + remedy_of_ironing;
    if (!necking_.torn())
      return "";
    if (!stage.continue_after_necking)
      return "the sheet tears: " + necking_.finding() +
             ". Draw less deep, or with less friction, less holder force or larger radii; to go on all the same, set "
             "Steps/" +
             stage.name + "/Continue after necking = true and --resume";
    neck_ignored_ = necking_.finding();
    return "";
  }


  std::vector<std::string> ResultCheck::warnings(const int exit_status) const
  {
    std::vector<std::string> result;
    if (!neck_ignored_.empty())
      result.push_back("necked: " + neck_ignored_ + ". What was computed after that depends on the mesh.");
    if (std::abs(last_energy_error_) > largest_energy_error)
      result.push_back("energy balance: works and energies differ by " + text::percent(std::abs(last_energy_error_)) +
                       " at the end. Set a smaller Largest increment in Steps/<stage>.");
    if (friction_error_ > largest_friction_error * friction_ && friction_ > least_friction * work_)
      result.push_back("friction work: it is uncertain by about " + text::percent(friction_error_ / friction_) +
                       ", because nodes begin and end to slide within increments that are long. Set a smaller Largest "
                       "increment in Steps/<stage>.");
    if (worst_balance_ > largest_imbalance)
      result.push_back("force balance: the forces of tools, supports and loads leave " + text::percent(worst_balance_) +
                       " of the largest of them unbalanced at time " + text::rounded(balance_time_) +
                       ". Set smaller Solver/Force tolerance and Relaxed force tolerance.");
    if (actors_.blank->is_sheet() && thinnest_ < thinnest_ratio * actors_.blank->initial_thickness())
      result.push_back("thickness: the sheet is " + text::rounded(thinnest_) + " thin at its thinnest point, " +
                       text::percent(thinnest_ / actors_.blank->initial_thickness()) +
                       " of what it was. A real sheet has torn before.");
    if (exit_status == exit_status::done)
      for (unsigned int i = 0; i < touched_.size(); ++i)
        if (!touched_[i])
          result.push_back("tool '" + actors_.tools[i]->name() +
                           "' has never touched the blank. Look at its position, side and motion, or leave it out.");
    if (n_snaps_ > 0)
      result.push_back("snap: in " + std::to_string(n_snaps_) +
                       " increments the blank snapped to another equilibrium, and nodes turned by up to " +
                       text::rounded(largest_turn_) + " rad (the most at time " + text::rounded(snap_time_) +
                       "), more than Solver/Largest rotation increment. Look at the pictures before and after: which "
                       "equilibrium the blank snaps to is not certain.");
    return result;
  }
} // namespace deltaform
