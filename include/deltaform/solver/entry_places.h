#pragma once

#include <deltaform/assembly/types.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace deltaform
{
  /**
   * Where the entries of element matrices lie in the array of values of a sparse matrix. Searching them is expensive,
   * so the places of every element that ever came are kept. Elements come in much the same order in every pass: the one
   * that followed last time is looked at first, then the one before that, as an edge in contact may name the same
   * unknowns as the element of the blank. Any other one is found by its unknowns.
   */
  class EntryPlaces
  {
  public:
    /// The place of an entry that is not in the matrix.
    static constexpr int nowhere = -1;

    /// Begin a pass over the elements.
    void restart()
    {
      last_ = start;
    }

    /**
     * The n x n places of the next element, row-major; valid until the next call.
     * @param kind 0 or 1: with the same unknowns, elements of different kinds may have different places
     * @param find find(row, column) is called for places that are not known
     */
    template <typename Find>
    const int *next(const DofIndex *dofs, const unsigned int n, const unsigned int kind, const Find &find)
    {
      const Name name{2 * n + kind, dofs};
      auto &[recent, earlier] = elements_[last_].followers;
      if (!is(recent, name))
      {
        std::swap(recent, earlier);
        if (!is(recent, name))
        {
          const std::size_t found = element(name, find); // may move all elements
          elements_[last_].followers[0] = found;
        }
      }
      last_ = elements_[last_].followers[0];
      return places_.data() + elements_[last_].place;
    }

  private:
    /// What tells elements apart.
    struct Name
    {
      unsigned int size() const
      {
        return head / 2;
      }

      std::size_t hash() const
      {
        return boost::hash_range(dofs, dofs + size()) + head;
      }

      unsigned int head; ///< 2 n + kind
      const DofIndex *dofs;
    };

    struct Element
    {
      unsigned int head;
      std::size_t dof, place; ///< its first ones among those of all elements
      std::array<std::size_t, 2> followers{{start, start}}; ///< what came after it, last and before
    };

    static constexpr std::size_t start = 0; ///< what comes before the first element

    bool is(const std::size_t i, const Name &name) const
    {
      const Element &element = elements_[i];
      return element.head == name.head && std::equal(name.dofs, name.dofs + name.size(), dofs_.data() + element.dof);
    }

    /// The element of that name: a new one if it has not come yet.
    template <typename Find>
    std::size_t element(const Name &name, const Find &find)
    {
      const std::size_t hash = name.hash();
      for (auto [i, end] = by_hash_.equal_range(hash); i != end; ++i)
        if (is(i->second, name))
          return i->second;
      elements_.push_back({name.head, dofs_.size(), places_.size()});
      by_hash_.emplace(hash, elements_.size() - 1);
      dofs_.insert(dofs_.end(), name.dofs, name.dofs + name.size());
      for (unsigned int i = 0; i < name.size(); ++i)
        for (unsigned int j = 0; j < name.size(); ++j)
          places_.push_back(find(name.dofs[i], name.dofs[j]));
      return elements_.size() - 1;
    }

    std::vector<Element> elements_{{0, 0, 0}};
    std::unordered_multimap<std::size_t, std::size_t> by_hash_; ///< elements by the hash of their names
    std::vector<DofIndex> dofs_;
    std::vector<int> places_;
    std::size_t last_ = start; ///< the element that came last
  };
} // namespace deltaform
