#pragma once

#include <deltaform/increment/block_comparison.h>

namespace deltaform
{
  /**
   * How many sets a search (SetSearch) may meet before it ends with a guess: sixty, or ten in a process that moves
   * faster with them. A long strip needs sixty where a zone of contact moves by some places in a set; in another one
   * most searches come to no end, and most of the effort goes into them. A search does not tell which it is. So both
   * are tried where three fifths of the effort are in vain. What stays is compared again after ever longer pauses.
   */
  class SetLimit
  {
  public:
    static constexpr unsigned int many = 60, few = 10;

    /// Sets of a search now.
    unsigned int most() const
    {
      return is_few_ != comparison_.tries_other() ? few : many;
    }

    /// A search has met so many @p sets. @param ended with one that leads to itself
    void met(unsigned int sets, bool ended);

    /// An increment of this @p length was accepted, for so many @p iterations, failed attempts included.
    void accept(double length, unsigned int iterations);

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive &is_few_ &compares_ &count_ &pause_ &sets_ &vain_sets_ &waited_.effort &waited_.in_vain &comparison_;
    }

  private:
    void wait(double effort, double in_vain);
    void compare(double length, double effort);

    struct Waited
    {
      double effort = 0., in_vain = 0.; ///< in all, of searches that came to no end
    };

    static constexpr unsigned int first_pause = 20;

    bool is_few_ = false, compares_ = false;
    unsigned int count_ = 0, pause_ = first_pause; ///< increments of this pause; before the next comparison
    unsigned int sets_ = 0, vain_sets_ = 0; ///< since the last increment: all, of searches that came to no end
    Waited waited_; ///< in this pause
    BlockComparison<8, 1> comparison_; ///< of the own limit and the other one
  };
} // namespace deltaform
