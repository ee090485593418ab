#include <deltaform/base/child_process.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

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
    pid_t process   = 0;
    const int error = posix_spawn(&process, pointers[0], &actions, nullptr, pointers.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
      throw std::runtime_error("Cannot start '" + arguments.front() + "': " + std::strerror(error) + ".");
    return process;
  }


  EndedProcess wait_for_process()
  {
    int status    = 0;
    pid_t process = 0;
    do
      process = waitpid(-1, &status, 0);
    while (process < 0 && errno == EINTR);
    if (process < 0)
      throw std::runtime_error(std::string("No process to wait for: ") + std::strerror(errno) + ".");
    return {process, WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status)};
  }
} // namespace deltaform
