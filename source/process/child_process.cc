#include <deltaform/process/child_process.h>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <thread>

namespace deltaform
{
  namespace
  {
    /// The life of a copy: its output goes to @p console, and it leaves alone what it has from the original.
    [[noreturn]] void live(const std::function<int()> &job, const int console)
    {
      int status = EXIT_FAILURE;
      if (dup2(console, STDOUT_FILENO) >= 0 && dup2(console, STDERR_FILENO) >= 0)
      {
        close(console);
        try
        {
          status = job();
        }
        catch (const std::exception &error)
        {
          std::cerr << error.what() << std::endl;
        }
      }
      std::cout.flush();
      std::fflush(nullptr);
      _exit(status);
    }
  } // namespace


  int start_process(const std::function<int()> &job, const std::string &console)
  {
    const auto error = [](const std::string &what) {
      return std::runtime_error(what + ": " + std::strerror(errno) + ".");
    };
    const int file = open(console.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0)
      throw error("Cannot write '" + console + "'");
    // What is waiting here would be printed by both.
    std::cout.flush();
    std::cerr.flush();
    std::fflush(nullptr);
    const pid_t process = fork();
    if (process == 0)
    {
      prctl(PR_SET_PDEATHSIG, SIGTERM); // it does not outlive the one that waits for it
      live(job, file);
    }
    close(file);
    if (process < 0)
      throw error("Cannot start a process");
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


  void ask_process_to_end(const int process)
  {
    kill(process, SIGTERM);
  }


  void end_process(const int process)
  {
    kill(process, SIGKILL);
  }
} // namespace deltaform
