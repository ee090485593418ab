// Places of entries that are kept from pass to pass while elements come and go.
#include <deltaform/solver/entry_places.h>

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace deltaform;

namespace
{
  using Elements = std::vector<std::vector<DofIndex>>;

  const std::vector<DofIndex> a{0, 1}, b{1, 2, 3}, c{3, 4}, d{4, 5}, e{5, 6, 7}, f{8, 9};

  struct Places
  {
    /// Goes on with a pass: are all places right? Counts those that were searched.
    void add(const Elements &elements)
    {
      for (const auto &dofs : elements)
      {
        const auto n = static_cast<unsigned int>(dofs.size());
        const int *const found = places.next(dofs.data(), n, 0, [&](const DofIndex row, const DofIndex column) {
          ++searched;
          return static_cast<int>(100 * row + column);
        });
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            BOOST_TEST(found[i * n + j] == static_cast<int>(100 * dofs[i] + dofs[j]));
      }
    }

    unsigned int searched_in_pass(const Elements &elements)
    {
      places.restart();
      searched = 0;
      add(elements);
      return searched;
    }

    EntryPlaces places;
    unsigned int searched = 0;
  };
} // namespace


BOOST_AUTO_TEST_SUITE(entry_places)

BOOST_AUTO_TEST_CASE(places_are_searched_once)
{
  Places places;
  BOOST_TEST(places.searched_in_pass({a, b, c, d, e}) == 4 + 9 + 4 + 4 + 9);
  BOOST_TEST(places.searched_in_pass({a, b, c, d, e}) == 0);
  BOOST_TEST(places.searched_in_pass({a, d, e}) == 0);
  BOOST_TEST(places.searched_in_pass({b, f, d, c, a, a}) == 4);
  BOOST_TEST(places.searched_in_pass({c, f, e}) == 0);
  BOOST_TEST(places.searched_in_pass({a, b, c, d, e, f}) == 0);
}

BOOST_AUTO_TEST_CASE(elements_with_unknowns_in_common_have_places_of_their_own)
{
  Places places;
  const std::vector<DofIndex> reversed{1, 0}, longer{0, 1, 2}, shorter{0};
  BOOST_TEST(places.searched_in_pass({a, reversed, longer, shorter}) == 4 + 4 + 9 + 1);
  BOOST_TEST(places.searched_in_pass({shorter, longer, reversed, a}) == 0);
}

BOOST_AUTO_TEST_CASE(elements_of_other_kinds_have_places_of_their_own)
{
  EntryPlaces places;
  const auto find = [](const int place) { return [place](DofIndex, DofIndex) { return place; }; };
  places.restart();
  BOOST_TEST(places.next(a.data(), 2, 0, find(7))[0] == 7);
  places.restart();
  BOOST_TEST(places.next(a.data(), 2, 1, find(8))[0] == 8);
}

BOOST_AUTO_TEST_SUITE_END()
