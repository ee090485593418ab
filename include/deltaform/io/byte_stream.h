#pragma once

#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream.hpp>

#include <cstddef>
#include <string>
#include <utility>

namespace deltaform
{
  /// Bytes written through a stream, handed out without a copy; that of a std::ostringstream is one of megabytes.
  class ByteStream
  {
  public:
    ByteStream()
      : stream_(bytes_)
    {
      bytes_.reserve(room);
    }

    std::ostream &stream()
    {
      return stream_;
    }

    /// All that was written. An archive on the stream must have ended before: it writes its last bytes then.
    std::string take()
    {
      stream_.flush();
      return std::move(bytes_);
    }

  private:
    /// Up to this size the bytes are never moved. Pages that nothing is written to take no memory.
    static constexpr std::size_t room = 1u << 24;

    std::string bytes_;
    boost::iostreams::stream<boost::iostreams::back_insert_device<std::string>> stream_;
  };
} // namespace deltaform
