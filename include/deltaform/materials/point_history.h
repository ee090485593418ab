#pragma once

#include <deltaform/io/keyed_arrays.h>
#include <deltaform/materials/history_layout.h>

#include <cstddef>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * History of all points of a blank, in two flat arrays: committed (of the last accepted increment) and trial (of the
   * last iteration). It starts at zero. A Material reads the trial values as a starting guess only and overwrites them,
   * so whatever they are, the answer is the same; after commit() they are those of the increment before.
   */
  class PointHistory
  {
  public:
    PointHistory() = default;

    PointHistory(const std::size_t n_points, const HistoryLayout &layout)
      : layout_(layout), values_per_point_(layout.size()), committed_(n_points * values_per_point_, 0.),
        trial_(committed_)
    {
    }

    const HistoryLayout &layout() const
    {
      return layout_;
    }

    /// Values of point @p point and all that follow.
    const double *committed(const std::size_t point) const
    {
      return committed_.data() + point * values_per_point_;
    }
    double *committed(const std::size_t point)
    {
      return committed_.data() + point * values_per_point_;
    }
    const double *trial(const std::size_t point) const
    {
      return trial_.data() + point * values_per_point_;
    }
    double *trial(const std::size_t point)
    {
      return trial_.data() + point * values_per_point_;
    }

    /// The increment is accepted.
    void commit()
    {
      committed_.swap(trial_);
    }

    /// The increment is given up: nothing of it remains, not even as a starting guess.
    void rollback()
    {
      trial_ = committed_;
    }

    /// Every array of the state with its name, for PutInto and TakeFrom. A state of a law with another layout has none
    /// of these names.
    template <typename History, typename Action>
    static void each_array(History &history, const Action &action)
    {
      action(history.name("committed"), history.committed_);
      action(history.name("last iteration"), history.trial_);
    }

  private:
    /// Of an array in a state: what the values mean is part of it.
    std::string name(const std::string &which) const
    {
      return "history, " + which + " (" + layout_.to_string() + ")";
    }

    HistoryLayout layout_;
    unsigned int values_per_point_ = 0;
    std::vector<double> committed_, trial_;
  };
} // namespace deltaform
