#pragma once

namespace file_calls
{
  /// What happens at a call that changes a file: write, writev, pwrite, rename, remove, unlink, ftruncate.
  enum class Fault : unsigned char
  {
    none,
    killed, ///< the process is killed just before it
    disk_full ///< from it on, nothing more can be written
  };

  /// From now on calls of this process are counted, and the @p n th one has the fault.
  void arm(Fault fault, long n);

  /// How many calls there were since then.
  long count();
} // namespace file_calls
