#pragma once

#include <boost/serialization/binary_object.hpp>

#include <type_traits>
#include <vector>

namespace deltaform
{
  /// Save or load a vector of plain values as its bytes, so that a member that is added later is not forgotten. For
  /// archives that are read by the program that wrote them.
  template <typename Archive, typename Values>
  void archive_plain(Archive &archive, Values &values)
  {
    using T = typename Values::value_type;
    static_assert(std::is_trivially_copyable_v<T>);
    std::size_t n = values.size();
    archive &n;
    if constexpr (!std::is_const_v<Values>)
      values.resize(n);
    if (n > 0)
      archive &boost::serialization::make_binary_object(values.data(), n * sizeof(T));
  }
} // namespace deltaform
