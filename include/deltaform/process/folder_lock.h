#pragma once

#include <string>

namespace deltaform
{
  /**
   * One run at a time writes into a folder. Its file deltaform.lock names the process and the machine that do; it goes
   * with the run. The system holds a lock on it as long as the process lives (flock), so that what a killed run left
   * behind is recognized on the same machine. Of a run on another machine it cannot be known whether it still lives.
   * Of several processes of a run, the first one holds it.
   */
  class FolderLock
  {
  public:
    /// @param force take the folder also where the owner may be alive
    /// @throws SceneError, on all processes of a run, if the folder belongs to another run or cannot be written
    FolderLock(const std::string &folder, bool force);
    ~FolderLock();
    FolderLock(const FolderLock &) = delete;
    FolderLock &operator=(const FolderLock &) = delete;

    /// The file inside @p folder.
    static std::string path(const std::string &folder);

  private:
    /// @return what is wrong; nothing if the folder is ours
    std::string take(bool force);

    std::string path_;
    int file_ = -1;
  };
} // namespace deltaform
