// Functions of the C library that change files, replaced by ones that count and may fail. An executable's own functions
// come first for the libraries that it loads, too (the streams of C++ among them). Files on disk count; pipes do not.
#include "file_calls.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>

namespace
{
  std::atomic<bool> armed{false};
  file_calls::Fault fault = file_calls::Fault::none;
  long faulty = 0;
  std::atomic<long> n_calls{0};

  bool on_disk(const int file)
  {
    struct stat found = {};
    return fstat(file, &found) == 0 && S_ISREG(found.st_mode);
  }

  /// Count a call. @return may it do its work?
  bool allowed(const bool needs_space)
  {
    if (!armed)
      return true;
    const long n = ++n_calls;
    if (fault == file_calls::Fault::killed && n == faulty)
      raise(SIGKILL);
    if (fault != file_calls::Fault::disk_full || n < faulty || !needs_space)
      return true;
    errno = ENOSPC;
    return false;
  }

  int unlink_at(const char *path, const int flags)
  {
    return static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, path, flags));
  }
} // namespace


namespace file_calls
{
  void arm(const Fault wanted, const long n)
  {
    fault = wanted;
    faulty = n;
    n_calls = 0;
    armed = true;
  }

  long count()
  {
    return n_calls;
  }
} // namespace file_calls


extern "C"
{
  ssize_t write(const int file, const void *bytes, const size_t n)
  {
    return !on_disk(file) || allowed(true) ? syscall(SYS_write, file, bytes, n) : -1;
  }

  ssize_t writev(const int file, const iovec *blocks, const int n)
  {
    return !on_disk(file) || allowed(true) ? syscall(SYS_writev, file, blocks, n) : -1;
  }

  ssize_t pwrite(const int file, const void *bytes, const size_t n, const off_t place)
  {
    return !on_disk(file) || allowed(true) ? syscall(SYS_pwrite64, file, bytes, n, place) : -1;
  }

  int ftruncate(const int file, const off_t length) noexcept
  {
    return allowed(false) ? static_cast<int>(syscall(SYS_ftruncate, file, length)) : -1;
  }

  int rename(const char *from, const char *to) noexcept
  {
    return allowed(false) ? static_cast<int>(syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to)) : -1;
  }

  int unlink(const char *path) noexcept
  {
    return allowed(false) ? unlink_at(path, 0) : -1;
  }

  int remove(const char *path) noexcept
  {
    if (!allowed(false))
      return -1;
    const int result = unlink_at(path, 0);
    return result != 0 && (errno == EISDIR || errno == EPERM) ? unlink_at(path, AT_REMOVEDIR) : result;
  }
}
