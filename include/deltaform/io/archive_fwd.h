#pragma once

// The archives that states are saved in, by name.
namespace boost::archive
{
  class binary_oarchive;
  class binary_iarchive;
} // namespace boost::archive
