#pragma once

#include <string>

namespace deltaform
{
  class Section;

  namespace memory
  {
    /// Bytes that this process can still get: what the machine has free, the limits of its group and its own. Infinite
    /// where that cannot be found out.
    double available();

    /**
     * Is there memory for what an entry asks for? Asked before anything is allocated, so that a number with a few
     * zeros too many is refused and the machine goes on.
     * @param n     number of things
     * @param what  they are called, for example "elements"
     * @param bytes that each of them takes at least
     * @throws SceneError naming the entry
     */
    void require(const Section &section, const std::string &entry, double n, const std::string &what, double bytes);
  } // namespace memory
} // namespace deltaform
