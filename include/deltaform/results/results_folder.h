#pragma once

#include <deltaform/io/background_writer.h>
#include <deltaform/io/units.h>
#include <deltaform/process/folder_lock.h>
#include <deltaform/process/journal.h>
#include <deltaform/process/timers.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace deltaform
{
  /// What the files of a run have in common.
  struct ResultsHead
  {
    std::string folder, title, units;
    bool axisymmetric;
  };

  /// The folder that a run writes into. Files are written while the computation goes on.
  class ResultsFolder
  {
  public:
    /**
     * Make the folder where there is none, and take it for this run. What is in it stays untouched until begin().
     * @param force also where another run seems to write into it
     * @throws SceneError if that is not possible
     */
    ResultsFolder(const ResultsHead &head, Journal &journal, Timers &timers, bool force = false);

    /**
     * The run will go on for certain: write the scene as it was read, and open the log.
     * @param print_scene writes the scene with every default
     * @param resumed     go on with what is there; else the results of an earlier run are removed
     * @throws SceneError if something cannot be written
     */
    void begin(const std::function<void(std::ostream &)> &print_scene, bool resumed);

    std::string path(const std::string &file) const
    {
      return folder_ + "/" + file;
    }

    const std::string &name() const
    {
      return folder_;
    }

    const std::string &title() const
    {
      return title_;
    }

    const Units &units() const
    {
      return units_;
    }

    const std::string &units_label() const
    {
      return label_;
    }

    /// Lines for the head of a table, without "#".
    const std::vector<std::string> &comments() const
    {
      return comments_;
    }

    Journal &journal()
    {
      return journal_;
    }

    Timers &timers()
    {
      return timers_;
    }

    /// Does tasks one after the other; they must own what they need.
    BackgroundWriter &writer()
    {
      return writer_;
    }

  private:
    std::string folder_, title_, label_;
    FolderLock lock_;
    Units units_;
    std::vector<std::string> comments_;
    Journal &journal_;
    Timers &timers_;
    BackgroundWriter writer_;
  };
} // namespace deltaform
