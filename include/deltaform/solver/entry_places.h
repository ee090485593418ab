#pragma once

#include <deltaform/base/types.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace deltaform
{
  /**
   * Places of the entries of element matrices in the values of a sparse matrix, kept from one pass over the elements to
   * the next. Elements come in the same order in every pass, so that the n unknowns of the next one are compared with
   * those that were met at this place of the last pass, and the n^2 entries need not be searched. Where the order
   * changes (a node has touched a tool), what follows is searched anew, and the result is the same in any case.
   */
  class EntryPlaces
  {
  public:
    /// An entry that is not in the matrix.
    static constexpr int nowhere = -1;

    /// A pass begins.
    void restart()
    {
      key_ = place_ = 0;
    }

    /**
     * The n x n places of the next element, row-major; valid until the next call.
     * @param kind 0 or 1: elements of another kind have other places
     * @param find called as find(row, column) for those that are not known yet
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
