#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/memory.h>

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

namespace deltaform::memory
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    /// "MemAvailable:  123 kB" of a file of the kernel, in bytes. @return infinity if there is no such line
    double kilobytes_of(const std::string &path, const std::string &name)
    {
      std::ifstream file(path);
      for (std::string line; std::getline(file, line);)
        if (line.rfind(name, 0) == 0)
        {
          std::istringstream words(line.substr(name.size()));
          if (double value = 0.; words >> value)
            return 1024. * value;
        }
      return infinity;
    }

    double number_in(const std::string &path)
    {
      std::ifstream file(path);
      double value = 0.;
      return file >> value ? value : infinity; // "max" is no number
    }
  } // namespace


  double available()
  {
    double result = kilobytes_of("/proc/meminfo", "MemAvailable:");
    // Control groups, version 2: that of a container.
    if (const double most = number_in("/sys/fs/cgroup/memory.max"); most < infinity)
      result = std::min(result, most - std::min(most, number_in("/sys/fs/cgroup/memory.current")));
    if (rlimit limit = {}; getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    {
      const double used = kilobytes_of("/proc/self/status", "VmSize:");
      result = std::min(result, std::max(0., static_cast<double>(limit.rlim_cur) - (used < infinity ? used : 0.)));
    }
    return result;
  }


  void require(const Section &section, const std::string &entry, const double n, const std::string &what,
               const double bytes)
  {
    constexpr double always = 1e8; // bytes that need no question
    if (n * bytes < always || section.documentation())
      return;
    const double free = available();
    if (n * bytes > free)
      section.fail(entry,
                   text::rounded(n) + " " + what + " need about " + text::rounded(n * bytes / 1e9) +
                     " GB of memory, and " + text::rounded(free / 1e9) + " GB are free: take fewer");
  }
} // namespace deltaform::memory
