#pragma once

#include <array>

namespace deltaform
{
  /// Components of a symmetric 3x3 tensor whose third axis is principal, in Mandel order (11, 22, 33, sqrt(2) 12).
  using Mandel = std::array<double, 4>;
} // namespace deltaform
