#pragma once

#include <boost/serialization/binary_object.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace deltaform
{
  /// Save or load a vector of plain values as its bytes, so that a member that is added later is not left out; a type
  /// with gaps between its members fills them. For archives that are read by the program that wrote them.
  template <typename Archive, typename Values>
  void archive_plain(Archive &archive, Values &values)
  {
    using T = typename Values::value_type;
    static_assert(std::is_trivially_copyable_v<T>);
    std::size_t n = values.size();
    archive &n;
    if constexpr (std::is_const_v<Values>)
    {
      if (n > 0)
        archive &boost::serialization::make_binary_object(values.data(), n * sizeof(T));
    }
    else
    {
      // Piece by piece: a damaged length ends at the end of the archive, before it has taken all memory.
      constexpr std::size_t piece = (std::size_t(1) << 20) / sizeof(T) + 1;
      if constexpr (Archive::is_loading::value)
        values.clear();
      for (std::size_t done = 0; done < n;)
      {
        const std::size_t next = std::min(n, done + piece);
        if constexpr (Archive::is_loading::value)
          values.resize(next);
        archive &boost::serialization::make_binary_object(values.data() + done, (next - done) * sizeof(T));
        done = next;
      }
    }
  }
} // namespace deltaform
