#include <deltaform/base/atomic_file.h>
#include <deltaform/base/ranks.h>
#include <deltaform/base/scene_error.h>

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
  } // namespace


  void replace_file(const std::string &path, const std::function<void(const std::string &)> &write)
  {
    if (!ranks::first())
      return;
    const std::string draft = path + ".part";
    write(draft);
    if (std::rename(draft.c_str(), path.c_str()) != 0)
      fail(path);
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
