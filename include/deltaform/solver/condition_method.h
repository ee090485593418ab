#pragma once

namespace deltaform
{
  namespace condition
  {
    /// How singular values are computed.
    enum class Method : unsigned char
    {
      automatic, ///< dense for up to 300 unknowns
      dense,
      lanczos
    };
  } // namespace condition
} // namespace deltaform
