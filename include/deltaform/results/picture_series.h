#pragma once

#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /// The file scene.pvd: all pictures so far with their times, complete and valid after each one.
  class PictureSeries
  {
  public:
    /// Begin a new series; nothing is written before the first picture.
    explicit PictureSeries(std::string path);

    /**
     * Go on with the series that is on disk, without the pictures later than @p time. No file is an empty series.
     * @throws SceneError if the file is no such series.
     */
    void resume(double time);

    /// Add a picture that consists of the files @p parts (relative to the folder of the series). @throws SceneError
    void add(double time, const std::vector<std::string> &parts);

    unsigned int size() const
    {
      return static_cast<unsigned int>(pictures_.size());
    }

    const std::vector<std::pair<double, std::vector<std::string>>> &pictures() const
    {
      return pictures_;
    }

  private:
    std::string path_;
    std::vector<std::pair<double, std::vector<std::string>>> pictures_;
  };
} // namespace deltaform
