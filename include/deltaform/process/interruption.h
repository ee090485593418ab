#pragma once

#include <string>

namespace deltaform
{
  /**
   * A signal that asks the program to end: SIGINT, SIGTERM, SIGXFSZ (a file became larger than it may) and SIGPIPE
   * (nobody reads what is written). It is remembered; who computes asks for it between two increments and between two
   * attempts at one, saves the state and ends with status 128 + signal.
   */
  namespace interruption
  {
    /// From now on signals are remembered. One that the program was started to ignore stays ignored; a second SIGINT or
    /// SIGTERM ends the program at once.
    void watch();

    /// The number of the first signal that has come; 0: none.
    int signal();

    /// "signal 15 (Terminated)".
    std::string name(int signal);
  } // namespace interruption
} // namespace deltaform
