#include <deltaform/process/interruption.h>

#include <csignal>
#include <cstring>

namespace deltaform::interruption
{
  namespace
  {
    volatile std::sig_atomic_t first = 0;

    extern "C" void remember(const int signal)
    {
      if (first == 0)
        first = signal;
    }

    void watch(const int signal, const int flags)
    {
      struct sigaction now = {};
      if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler == SIG_IGN)
        return;
      struct sigaction own = {};
      own.sa_handler = remember;
      own.sa_flags = flags;
      sigemptyset(&own.sa_mask);
      sigaction(signal, &own, nullptr);
    }
  } // namespace


  void watch()
  {
    for (const int signal : {SIGINT, SIGTERM})
      watch(signal, SA_RESTART | static_cast<int>(SA_RESETHAND));
    // These come again with every byte that is not taken.
    for (const int signal : {SIGXFSZ, SIGPIPE})
      watch(signal, SA_RESTART);
  }


  int signal()
  {
    return first;
  }


  std::string name(const int signal)
  {
    return "signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  }
} // namespace deltaform::interruption
