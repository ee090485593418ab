#pragma once

#include <memory>

namespace deltaform
{
  /// MPI from the beginning to the end of an object, with one thread per process.
  class MpiSession
  {
  public:
    /// Was this process started by mpirun or its like?
    static bool launched();

    /// Start MPI; a process that nobody has launched starts it without a transport to others.
    MpiSession(int argc, char **argv);
    ~MpiSession();

    MpiSession(const MpiSession &) = delete;
    MpiSession &operator=(const MpiSession &) = delete;

  private:
    struct Running;
    std::unique_ptr<Running> running_;
  };
} // namespace deltaform
