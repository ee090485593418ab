#pragma once

namespace deltaform
{
  /// An allowed penetration as contact points inside the elements see it: with a coarse one the face between them is
  /// little deeper than they are, with a fine one many times as deep (doc/theory/contact.md).
  enum class DeltaSize : unsigned char
  {
    coarse,
    fine
  };
} // namespace deltaform
