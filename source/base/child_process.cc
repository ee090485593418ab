#include <deltaform/base/child_process.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <thread>

namespace deltaform
{
  namespace
  {
    /// What a library tells a process about itself must not be told to its children: they are no ranks of this one.
    std::vector<char *> environment_without_ranks()
    {
      std::vector<char *> result;
      for (char **entry = environ; *entry != nullptr; ++entry)
      {
        const std::string text = *entry;
        if (text.rfind("PMIX_", 0) != 0 && text.rfind("PMI_", 0) != 0 && text.rfind("OMPI_COMM_WORLD", 0) != 0)
          result.push_back(*entry);
      }
      result.push_back(nullptr);
      return result;
    }
  } // namespace


  std::string own_program()
  {
    return std::filesystem::read_symlink("/proc/self/exe").string();
  }


  int start_process(const std::vector<std::string> &arguments, const std::string &console)
  {
    std::vector<char *> pointers;
    for (const auto &argument : arguments)
      pointers.push_back(const_cast<char *>(argument.c_str())); // posix_spawn does not write to them
    pointers.push_back(nullptr);
    auto environment = environment_without_ranks();

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, console.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t process = 0;
    const int error = posix_spawn(&process, pointers[0], &actions, nullptr, pointers.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
      throw std::runtime_error("Cannot start '" + arguments.front() + "': " + std::strerror(error) + ".");
    return process;
  }


  std::optional<EndedProcess> wait_for_process(const double seconds)
  {
    // POSIX has no waitpid with a limit. Asking now and then is exact enough where processes take tenths of a second.
    constexpr std::chrono::milliseconds pause(5);
    const bool limited = std::isfinite(seconds);
    const auto begin = std::chrono::steady_clock::now();
    while (true)
    {
      int status = 0;
      const pid_t process = waitpid(-1, &status, limited ? WNOHANG : 0);
      if (process > 0)
        return EndedProcess{process, WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status)};
      if (process < 0 && errno != EINTR)
        throw std::runtime_error(std::string("No process to wait for: ") + std::strerror(errno) + ".");
      if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > seconds)
        return {};
      if (process == 0)
        std::this_thread::sleep_for(pause);
    }
  }


  void end_process(const int process)
  {
    kill(process, SIGKILL);
  }
} // namespace deltaform
