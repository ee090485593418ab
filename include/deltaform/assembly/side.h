#pragma once

#include <array>
#include <vector>

namespace deltaform
{
  /// A face of the blank. The director (left of the meridian, walked from start to end) points out of the top face.
  enum class Side : unsigned char
  {
    bottom,
    top
  };

  /// Values at the nodes, for each Side.
  using FaceValues = std::array<std::vector<double>, 2>;
} // namespace deltaform
