#pragma once

#include <string>
#include <vector>

namespace deltaform
{
  /// The file scene.pvd: all pictures so far with their times, complete and valid after each one.
  class PictureSeries
  {
  public:
    /// A file of a picture (relative to the folder of the series), and the name under which ParaView lists it.
    struct Part
    {
      std::string file, name;
    };

    /// A time and what is drawn of it.
    struct Picture
    {
      double time;
      std::vector<Part> parts;
    };

    /// Begin a new series; nothing is written before the first picture.
    explicit PictureSeries(std::string path);

    /**
     * Go on with the series that is on disk, without the pictures later than @p time. No file is an empty series.
     * @throws SceneError if the file is no such series.
     */
    void resume(double time);

    /// Add a picture that consists of @p parts. @throws SceneError
    void add(double time, const std::vector<Part> &parts);

    unsigned int size() const
    {
      return static_cast<unsigned int>(pictures_.size());
    }

    const std::vector<Picture> &pictures() const
    {
      return pictures_;
    }

  private:
    std::string path_;
    std::vector<Picture> pictures_;
  };
} // namespace deltaform
