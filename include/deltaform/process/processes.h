#pragma once

#include <mpi.h>

namespace deltaform::ranks
{
  /// Says which processes work together on a run, from its making to its end; without one, every process works alone.
  /// MPI has to be started before, and must not end before. One at a time.
  class Processes
  {
  public:
    explicit Processes(MPI_Comm communicator);
    ~Processes();

    Processes(const Processes &) = delete;
    Processes &operator=(const Processes &) = delete;
  };
} // namespace deltaform::ranks
