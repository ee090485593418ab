#pragma once

#include <deltaform/results/history.h>
#include <deltaform/scene/forming_problem.h>
#include <deltaform/scene/ironing.h>
#include <deltaform/scene/necking.h>

#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Looks at the accepted increments of a run and says what an engineer should know of its result: why it cannot be
   * used any further (torn, ironed), and at the end what makes it doubtful, each with what to do about it.
   */
  class ResultCheck
  {
  public:
    explicit ResultCheck(const Actors &actors);

    /// An increment was accepted. @param row its row of history.csv
    void observe(const Stage &stage, const HistoryRow &row);

    /// The blank has snapped in an increment, and a node has turned by @p rotation (rad), more than is allowed.
    void snapped(const HistoryRow &row, double rotation);

    /// Why the result cannot be used from here on; empty if it can.
    std::string failure(const Stage &stage);

    /// What may be the cause that the next increment could not be solved; empty if nothing is known.
    std::string likely_cause() const;

    /// What makes the result of a run doubtful that has ended with @p exit_status.
    std::vector<std::string> warnings(int exit_status) const;

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &necking_ &ironing_ &touched_ &worst_balance_ &balance_time_ &n_snaps_ &largest_turn_ &snap_time_
        &last_energy_error_ &thinnest_ &friction_ &friction_error_ &work_ &neck_ignored_;
    }

  private:
    const Actors &actors_;
    NeckingWatch necking_;
    IroningWatch ironing_;
    std::vector<bool> touched_; ///< tool by tool
    double worst_balance_ = 0, balance_time_ = 0;
    unsigned int n_snaps_ = 0;
    double largest_turn_ = 0, snap_time_ = 0;
    double last_energy_error_ = 0, thinnest_ = 0;
    double friction_ = 0, friction_error_ = 0, work_ = 0; ///< at the end
    std::string neck_ignored_; ///< what `Continue after necking` has passed over
  };
} // namespace deltaform
