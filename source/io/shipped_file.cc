#include <deltaform/io/shipped_file.h>

#include <dlfcn.h>

#include <filesystem>
#include <system_error>
#include <vector>

namespace deltaform
{
  namespace
  {
    namespace fs = std::filesystem;

    /// Where the code of this library may have come from: the shared library, or the program that it is linked into.
    std::vector<fs::path> origins()
    {
      std::vector<fs::path> result;
      Dl_info info;
      if (dladdr(reinterpret_cast<const void *>(&shipped_file), &info) != 0 && info.dli_fname != nullptr)
        result.emplace_back(info.dli_fname);
      result.emplace_back("/proc/self/exe"); // a program's name need not say where it is
      return result;
    }
  } // namespace


  std::string shipped_file(const std::string &name)
  {
    for (const fs::path &origin : origins())
    {
      std::error_code error;
      const fs::path file = fs::canonical(origin, error);
      if (error)
        continue;
      for (fs::path folder = file.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
        if (const fs::path candidate = folder / "share" / "deltaform" / name; fs::is_regular_file(candidate, error))
          return candidate.string();
    }
    return "";
  }
} // namespace deltaform
