#pragma once

#include <deltaform/base/scene_error.h>
#include <deltaform/materials/history_layout.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

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

    /// @throws SceneError if what is loaded was saved by a law with another layout
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      std::string saved = layout_.to_string();
      archive &saved;
      if (saved != layout_.to_string())
        throw SceneError("Cannot resume: the history of the material was saved as '" + saved +
                         "', this material has '" + layout_.to_string() + "'.");
      archive &committed_ &trial_;
    }

  private:
    HistoryLayout layout_;
    unsigned int values_per_point_ = 0;
    std::vector<double> committed_, trial_;
  };
} // namespace deltaform
