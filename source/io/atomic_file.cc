#include <deltaform/io/atomic_file.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/process/ranks.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace deltaform
{
  namespace
  {
    [[noreturn]] void fail(const std::string &path)
    {
      throw SceneError("Cannot write '" + path + "': " + std::strerror(errno) + ".");
    }
    /// A file under construction, which is gone if nothing becomes of it.
    class Draft
    {
    public:
      explicit Draft(const std::string &path)
        : path_(path), name_(path + ".part")
      {
      }
      ~Draft()
      {
        if (!renamed_)
          std::remove(name_.c_str());
      }
      Draft(const Draft &) = delete;
      Draft &operator=(const Draft &) = delete;

      const std::string &name() const
      {
        return name_;
      }

      void rename()
      {
        if (std::rename(name_.c_str(), path_.c_str()) != 0)
          fail(path_);
        renamed_ = true;
      }

    private:
      std::string path_, name_;
      bool renamed_ = false;
    };
  } // namespace


  void replace_file(const std::string &path, const std::function<void(const std::string &)> &write)
  {
    if (!ranks::first())
      return;
    Draft draft(path);
    write(draft.name());
    draft.rename();
  }


  void write_file_atomically(const std::string &path, const std::function<void(std::ostream &)> &write)
  {
    replace_file(path,
                 [&](const std::string &draft) {
                   std::ofstream file(draft);
                   if (!file)
                     fail(path);
                   write(file);
                   file.close();
                   if (!file)
                     fail(path);
                 });
  }
} // namespace deltaform
