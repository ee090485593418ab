#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/folder_lock.h>
#include <deltaform/process/ranks.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <sstream>

namespace deltaform
{
  namespace
  {
    std::string machine()
    {
      std::array<char, 256> name = {};
      if (gethostname(name.data(), name.size() - 1) != 0)
        return "unknown";
      return name.data();
    }

    /// The first line of an open file, "process 12 on machine".
    std::string owner_in(const int file)
    {
      std::array<char, 512> bytes = {};
      const ssize_t n = pread(file, bytes.data(), bytes.size() - 1, 0);
      std::istringstream text(std::string(bytes.data(), n > 0 ? static_cast<std::size_t>(n) : 0));
      std::string line;
      std::getline(text, line);
      return line;
    }

    /// Is the open file still the one that has this name?
    bool is_still(const int file, const std::string &path)
    {
      struct stat open_one = {}, named = {};
      return fstat(file, &open_one) == 0 && stat(path.c_str(), &named) == 0 && open_one.st_ino == named.st_ino &&
             open_one.st_dev == named.st_dev;
    }

    std::string advice()
    {
      return ". Two runs in one folder would mix their files: choose another --output, or take this one by --force if "
             "that run is over";
    }
  } // namespace


  std::string FolderLock::path(const std::string &folder)
  {
    return folder + "/deltaform.lock";
  }


  FolderLock::FolderLock(const std::string &folder, const bool force)
    : path_(path(folder))
  {
    const std::string wrong = ranks::first() ? take(force) : std::string();
    if (!ranks::decided_by_first(wrong.empty()))
      throw SceneError("The folder '" + folder + "' " + wrong + ".");
  }


  std::string FolderLock::take(const bool force)
  {
    const std::string unwritable = "cannot be written ('" + path_ + "')";
    const auto failed = [](const std::string &what) {
      return what + ": " + std::strerror(errno) + ". Choose another with --output or Output/Folder";
    };
    for (;;)
    {
      file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
      if (file_ < 0)
        return failed(unwritable);
      if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK && !force)
      {
        const std::string owner = owner_in(file_);
        close(file_);
        file_ = -1;
        return "is in use by " + (owner.empty() ? "another run" : owner) + advice();
      }
      if (is_still(file_, path_))
        break;
      close(file_); // its owner has just removed it
    }
    const std::string here = " on " + machine();
    const std::string owner = owner_in(file_);
    const bool elsewhere =
      !owner.empty() && (owner.size() < here.size() ||
                         owner.compare(owner.size() - here.size(), std::string::npos, here) != 0);
    if (elsewhere && !force)
    {
      close(file_);
      file_ = -1;
      return "belongs to " + owner + ", which may still run or was killed" + advice();
    }
    const std::string own = "process " + std::to_string(getpid()) + here + "\n";
    if (ftruncate(file_, 0) != 0 || pwrite(file_, own.data(), own.size(), 0) != static_cast<ssize_t>(own.size()))
    {
      std::string wrong = failed(unwritable);
      unlink(path_.c_str());
      close(file_);
      file_ = -1;
      return wrong;
    }
    return "";
  }


  FolderLock::~FolderLock()
  {
    if (file_ < 0)
      return;
    unlink(path_.c_str());
    close(file_);
  }
} // namespace deltaform
