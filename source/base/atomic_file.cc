#include <deltaform/base/atomic_file.h>
#include <deltaform/base/ranks.h>
#include <deltaform/base/scene_error.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace deltaform
{
  void write_file_atomically(const std::string &path, const std::function<void(std::ostream &)> &write)
  {
    if (!ranks::first())
      return;
    const std::string draft = path + ".part";
    const auto fail = [&path]() { throw SceneError("Cannot write '" + path + "': " + std::strerror(errno) + "."); };
    {
      std::ofstream file(draft);
      if (!file)
        fail();
      write(file);
      file.close();
      if (!file)
        fail();
    }
    if (std::rename(draft.c_str(), path.c_str()) != 0)
      fail();
  }
} // namespace deltaform
