#pragma once

namespace deltaform
{
  /// A face of the blank. The director (left of the meridian, walked from start to end) points out of the top face.
  enum class Side : unsigned char
  {
    bottom,
    top
  };
} // namespace deltaform
