#pragma once

#include <boost/serialization/binary_object.hpp>

#include <type_traits>
#include <vector>

namespace deltaform
{
  /// Save or load a vector of plain values as its bytes, so that a member that is added later is not forgotten. For
  /// archives that are read by the program that wrote them.
  template <typename Archive, typename T>
  void archive_plain(Archive &archive, std::vector<T> &values)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    std::size_t n = values.size();
    archive &n;
    values.resize(n);
    if (n > 0)
      archive &boost::serialization::make_binary_object(values.data(), n * sizeof(T));
  }
} // namespace deltaform
