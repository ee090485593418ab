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
   * pass: if the n unknowns of an element are those that came at the same position of the last pass, its n^2 places are
   * known. Otherwise (a node has touched a tool) the places of this and all further elements are searched again. The
   * result is the same in both cases.
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
      key_ = position.key;
      place_ = position.place;
    }

    /// Begin a pass.
    void restart()
    {
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
      if (key_ < keys_.size() && keys_[key_] == head && std::equal(dofs, dofs + n, keys_.data() + key_ + 1))
      {
        key_ += 1 + n;
        place_ += std::size_t(n) * n;
        return places_.data() + place_ - std::size_t(n) * n;
      }
      keys_.resize(key_);
      places_.resize(place_);
      keys_.push_back(head);
      keys_.insert(keys_.end(), dofs, dofs + n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          places_.push_back(find(dofs[i], dofs[j]));
      const std::size_t first = place_;
      key_ = keys_.size();
      place_ = places_.size();
      return places_.data() + first;
    }

  private:
    std::vector<DofIndex> keys_; ///< of every element: 2 n + kind, then its unknowns
    std::vector<int> places_;
    std::size_t key_ = 0, place_ = 0; ///< of the next element
  };
} // namespace deltaform
