#pragma once

#include <deltaform/base/drawing.h>
#include <deltaform/results/units.h>

#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /// Write a drawing as an unstructured grid for ParaView; fields are called "name [unit]". @throws SceneError
  void
  write_vtu(const std::string &path, const Drawing &drawing, const Units &units);

  /// The file scene.pvd: all pictures so far with their times, complete and valid after each one.
  class PictureSeries
  {
  public:
    explicit PictureSeries(std::string path);

    /// Add a picture that consists of the files @p parts (relative to the folder of the series).
    void
    add(double time, const std::vector<std::string> &parts);

    unsigned int
    size() const
    {
      return static_cast<unsigned int>(pictures_.size());
    }

    const std::vector<std::pair<double, std::vector<std::string>>> &
    pictures() const
    {
      return pictures_;
    }

  private:
    std::string                                               path_;
    std::vector<std::pair<double, std::vector<std::string>>> pictures_;
  };
} // namespace deltaform
