// Builds scenes as --check does, each in a process of its own that costs no start-up, and says what became of it.
//
//     judge_inputs < LIST > VERDICTS
//
// A line of LIST: the file of a scene, then entries "A/B=c" for --set, separated by tabs. A line of VERDICTS: how it
// ended (valid, refused, memory, exception, signal, slow), kB of memory over the start-up, seconds, and what was said.
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>
#include <deltaform/scene/input_warnings.h>
#include <deltaform/scene/scene.h>

#include <deal.II/base/multithread_info.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>

namespace
{
  using namespace deltaform;

  enum Verdict : int
  {
    valid,
    refused,
    memory_used_up,
    exception
  };

  constexpr unsigned int patience = 20; // seconds
  constexpr rlim_t most_memory = rlim_t(4) << 30; // bytes of address space


  Verdict judge(const std::string &file, const std::vector<std::string> &sets, std::string &said)
  {
    try
    {
      auto tree = ParameterTree::read(file, sets);
      const Scene scene(tree);
      for (const auto &warning : input_warnings(scene))
        said += warning + " ";
      std::ostringstream echo;
      tree.print_prm(echo);
      return valid;
    }
    catch (const SceneError &error)
    {
      said = error.what();
      return refused;
    }
    catch (const std::bad_alloc &error)
    {
      said = error.what();
      return memory_used_up;
    }
    catch (const std::exception &error)
    {
      said = error.what();
      return exception;
    }
  }


  [[noreturn]] void live(const std::vector<std::string> &words, const int out)
  {
    const rlimit memory = {most_memory, most_memory};
    setrlimit(RLIMIT_AS, &memory);
    alarm(patience);
    std::string said;
    const Verdict verdict = judge(words.front(), {words.begin() + 1, words.end()}, said);
    said = text::printable(said.substr(0, 4000));
    for (char &c : said)
      if (c == '\n' || c == '\t')
        c = ' ';
    if (write(out, said.data(), said.size()) < 0)
      _exit(EXIT_FAILURE);
    _exit(verdict);
  }


  std::string read_all(const int in)
  {
    std::string result;
    char block[4096];
    for (ssize_t n = 0; (n = read(in, block, sizeof block)) > 0;)
      result.append(block, static_cast<std::size_t>(n));
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
} // namespace


int
main()
{
  dealii::MultithreadInfo::set_thread_limit(1);
  const char *const names[] = {"valid", "refused", "memory", "exception"};
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
    const pid_t process = fork();
    if (process == 0)
    {
      close(ends[0]);
      live(words, ends[1]);
    }
    close(ends[1]);
    const std::string said = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    rusage used = {};
    wait4(process, &status, 0, &used);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::string how = "exception";
    if (WIFSIGNALED(status))
      how = WTERMSIG(status) == SIGALRM ? "slow" : "signal " + std::to_string(WTERMSIG(status));
    else if (WEXITSTATUS(status) <= exception)
      how = names[WEXITSTATUS(status)];
    std::cout << how << '\t' << std::max(0L, used.ru_maxrss - before) << '\t' << seconds << '\t' << said << std::endl;
  }
  return EXIT_SUCCESS;
}
