#pragma once

#include <deltaform/assembly/status.h>
#include <deltaform/assembly/types.h>

#include <mpi.h>

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace deltaform
{
  /**
   * The processes of a run. One rule makes a parallel run simple: vectors of unknowns and all decisions are the same on
   * every process, only cells, their history and the rows of the matrix are distributed. All functions but count(),
   * mine() and first() are collective: every process calls them, in the same order. With one process, and where MPI was
   * never started (unit tests), they do nothing.
   */
  namespace ranks
  {
    unsigned int count();

    /// Number of this process.
    unsigned int mine();

    /// The one that writes files and talks to the user.
    bool first();

    MPI_Comm communicator();

    double sum(double value);
    double max(double value);
    double min(double value);

    /// @p value of the first process.
    bool decided_by_first(bool value);

    /// Entry by entry, in place.
    void sum(double *values, std::size_t n);

    /// The worst status, with its text from the first process that has it.
    Status worst(const Status &own);

    /// Bytes of all processes, one string per process.
    std::vector<std::string> gather(std::string own);

    /// The entries of all processes behind one another.
    template <typename T>
    std::vector<T> gather(const std::vector<T> &own)
    {
      static_assert(std::is_trivially_copyable<T>::value, "these are sent byte by byte");
      if (count() == 1)
        return own;
      std::vector<T> result;
      for (const auto &bytes : gather(std::string(reinterpret_cast<const char *>(own.data()), own.size() * sizeof(T))))
      {
        const std::size_t before = result.size();
        result.resize(before + bytes.size() / sizeof(T));
        if (!bytes.empty())
          std::memcpy(static_cast<void *>(&result[before]), bytes.data(), bytes.size());
      }
      return result;
    }

    /**
     * The end of a process, with or without an error: waits until all have come to theirs. If @p failed and another
     * one is still at work after two seconds (it may wait for this one for ever), all are ended with @p exit_status.
     * @param message is shown in that case; @return whether this process should show it otherwise
     */
    bool end_together(int exit_status, bool failed, const std::string &message);
  } // namespace ranks
} // namespace deltaform
