// The program with many command lines, each in a process of its own that costs no start-up: libraries are loaded once.
//
//     run_many SECONDS < COMMANDS > ENDS
//
// A line of COMMANDS: the words of a command line without the program's name, separated by tabs. A line of ENDS: how it
// ended ("status N", "signal N", "slow": it took more than SECONDS of processor time, or ten times that), kB of memory
// over the start-up, seconds, how often it changed a file, and what it said, with \n, \t and \\ for new line, tab and
// backslash.
//
// A command may begin with a fault: "@killed=N": the process is killed just before it changes a file for the Nth time;
// "@full=N": from then on nothing can be written, as on a full disk.
#include "file_calls.h"

#include <deltaform/app/program.h>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
  constexpr rlim_t most_memory = rlim_t(4) << 30; // bytes of address space
  constexpr std::size_t most_said = 20000; // bytes that are passed on


  /// Where the copies leave how often they have changed a file.
  long *shared_number()
  {
    void *place = mmap(nullptr, sizeof(long), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return place == MAP_FAILED ? nullptr : static_cast<long *>(place);
  }


  /// What @p words begin with, taken off.
  void arm(std::vector<std::string> &words)
  {
    file_calls::Fault fault = file_calls::Fault::none;
    const std::string first = words.front();
    const auto equals = first.find('=');
    if (first.rfind("@killed=", 0) == 0)
      fault = file_calls::Fault::killed;
    else if (first.rfind("@full=", 0) == 0)
      fault = file_calls::Fault::disk_full;
    if (fault != file_calls::Fault::none)
      words.erase(words.begin());
    file_calls::arm(fault, fault == file_calls::Fault::none ? 0 : std::atol(first.c_str() + equals + 1));
  }


  /// The life of a copy: the program, in limits.
  [[noreturn]] void live(std::vector<std::string> words, const int out, const unsigned int seconds, long *n_calls)
  {
    const rlimit memory = {most_memory, most_memory}, time = {seconds, seconds + 1};
    setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CPU, &time);
    alarm(10 * seconds);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    close(out);
    arm(words);
    std::vector<char *> argv;
    words.insert(words.begin(), "deltaform");
    for (auto &word : words)
      argv.push_back(&word[0]);
    argv.push_back(nullptr);
    const int status = deltaform::run_program(static_cast<int>(words.size()), argv.data());
    std::cout.flush();
    std::fflush(nullptr);
    *n_calls = file_calls::count();
    _exit(status);
  }


  /// What comes out of a pipe, in one line.
  std::string read_all(const int in)
  {
    std::string result;
    char block[4096];
    for (ssize_t n = 0; (n = read(in, block, sizeof block)) > 0;)
      for (ssize_t i = 0; i < n && result.size() < most_said; ++i)
        switch (block[i])
        {
        case '\n':
          result += "\\n";
          break;
        case '\t':
          result += "\\t";
          break;
        case '\\':
          result += "\\\\";
          break;
        default:
          result += block[i];
        }
    return result;
  }


  /// kB in memory now.
  long resident()
  {
    std::ifstream file("/proc/self/statm");
    long size = 0, pages = 0;
    file >> size >> pages;
    return pages * (sysconf(_SC_PAGESIZE) / 1024);
  }


  std::string in_words(const int status)
  {
    if (!WIFSIGNALED(status))
      return "status " + std::to_string(WEXITSTATUS(status));
    const int signal = WTERMSIG(status);
    return signal == SIGALRM || signal == SIGXCPU ? "slow" : "signal " + std::to_string(signal);
  }
} // namespace


int
main(int argc, char *argv[])
{
  const unsigned int seconds = argc > 1 ? static_cast<unsigned int>(std::max(1, std::atoi(argv[1]))) : 20;
  long *const n_calls = shared_number();
  if (n_calls == nullptr)
    return EXIT_FAILURE;
  for (std::string line; std::getline(std::cin, line);)
  {
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; std::getline(stream, word, '\t');)
      words.push_back(word);
    int ends[2];
    if (words.empty() || pipe(ends) != 0)
      return EXIT_FAILURE;
    const auto begin = std::chrono::steady_clock::now();
    const long before = resident();
    *n_calls = 0;
    const pid_t process = fork();
    if (process < 0)
      return EXIT_FAILURE;
    if (process == 0)
    {
      close(ends[0]);
      live(words, ends[1], seconds, n_calls);
    }
    close(ends[1]);
    const std::string said = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    rusage used = {};
    wait4(process, &status, 0, &used);
    const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::cout << in_words(status) << '\t' << std::max(0L, used.ru_maxrss - before) << '\t' << taken << '\t' << *n_calls
              << '\t' << said << std::endl;
  }
  return EXIT_SUCCESS;
}
