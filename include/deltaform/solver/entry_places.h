#pragma once

#include <deltaform/assembly/types.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace deltaform
{
  /**
   * Where the entries of element matrices lie in the array of values of a sparse matrix. Searching them is expensive,
   * so their places are kept from one pass over the elements to the next. Elements come in the same order in every
   * pass, but some come and others go (a node touches a tool): an element that came a little later in the last pass
   * takes the place of those in between, any other one is put in between, and its places are searched. The result is
   * the same in all cases.
   */
  class EntryPlaces
  {
  public:
    /// The place of an entry that is not in the matrix.
    static constexpr int nowhere = -1;

    /// Where a pass is.
    struct Position
    {
      std::size_t key = 0, place = 0;
    };

    Position position() const
    {
      return {key_, place_};
    }

    /// Go on from a position of this pass.
    void go_back(const Position position)
    {
      forget_rest();
      key_ = position.key;
      place_ = position.place;
    }

    /// Begin a pass.
    void restart()
    {
      forget_rest();
      key_ = place_ = 0;
    }

    /**
     * The n x n places of the next element, row-major; valid until the next call.
     * @param kind 0 or 1: with the same unknowns, elements of different kinds may have different places
     * @param find find(row, column) is called for places that are not known
     */
    template <typename Find>
    const int *next(const DofIndex *dofs, const unsigned int n, const unsigned int kind, const Find &find)
    {
      const DofIndex head = 2 * n + kind;
      if (!go_to(head, dofs, n))
        insert(head, dofs, n, find);
      key_ += 1 + n;
      place_ += std::size_t(n) * n;
      return places_.data() + place_ - std::size_t(n) * n;
    }

  private:
    /// So many elements of the last pass are looked through for one that has come.
    static constexpr unsigned int most_left_out = 6;

    /// What has not come in this pass.
    void forget_rest()
    {
      keys_.resize(key_);
      places_.resize(place_);
    }

    /// If the element is the next one of the last pass, or comes soon: those before it are dropped.
    bool go_to(const DofIndex head, const DofIndex *dofs, const unsigned int n)
    {
      std::size_t key = key_, place = place_;
      for (unsigned int i = 0; i <= most_left_out && key < keys_.size(); ++i)
      {
        const std::size_t size = keys_[key] / 2;
        if (keys_[key] == head && std::equal(dofs, dofs + n, keys_.data() + key + 1))
        {
          keys_.erase(keys_.begin() + key_, keys_.begin() + key);
          places_.erase(places_.begin() + place_, places_.begin() + place);
          return true;
        }
        key += 1 + size;
        place += size * size;
      }
      return false;
    }

    template <typename Find>
    void insert(const DofIndex head, const DofIndex *dofs, const unsigned int n, const Find &find)
    {
      const auto key = keys_.insert(keys_.begin() + key_, n + 1, head);
      std::copy_n(dofs, n, key + 1);
      auto place = places_.insert(places_.begin() + place_, std::size_t(n) * n, nowhere);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          *place++ = find(dofs[i], dofs[j]);
    }

    std::vector<DofIndex> keys_; ///< of every element: 2 n + kind, then its unknowns
    std::vector<int> places_;
    std::size_t key_ = 0, place_ = 0; ///< of the next element
  };
} // namespace deltaform
