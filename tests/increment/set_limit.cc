// How many sets a search may meet, by what the process makes of it.
#include <deltaform/increment/set_limit.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>

using namespace deltaform;

namespace
{
  /// What an increment is like with so many sets at most: its length, and what its one search meets.
  struct Increment
  {
    double length;
    unsigned int sets;
    bool ends; ///< the search, with a set
  };

  struct Outcome
  {
    unsigned int with_few = 0, with_many = 0; ///< increments
    double length = 0.;
  };

  constexpr unsigned int iterations = 4;

  Outcome run(SetLimit &limit,
              const std::function<Increment(bool few, double share)> &increment,
              const unsigned int increments)
  {
    Outcome result;
    for (unsigned int k = 0; k < increments; ++k)
    {
      const bool few = limit.most() == SetLimit::few;
      const auto [length, sets, ends] = increment(few, static_cast<double>(k) / increments);
      limit.met(sets, ends);
      limit.accept(length, iterations);
      ++(few ? result.with_few : result.with_many);
      result.length += length;
    }
    return result;
  }


  Outcome run(const std::function<Increment(bool few, double share)> &increment, const unsigned int increments = 1000)
  {
    SetLimit limit;
    return run(limit, increment, increments);
  }


  /// Searches without end: nothing but effort comes of the sets.
  Increment endless(const bool few, double)
  {
    return {1., few ? SetLimit::few : SetLimit::many, false};
  }


  /// A flange that peels off: few sets are a tenth of the way.
  Increment peels(const bool few, double)
  {
    return {few ? .1 : 1., few ? SetLimit::few : SetLimit::many, false};
  }
} // namespace

BOOST_AUTO_TEST_SUITE(set_limit)

BOOST_AUTO_TEST_CASE(few_where_searches_do_not_end)
{
  const auto outcome = run(endless);
  BOOST_TEST(outcome.with_few > 800u);
}

BOOST_AUTO_TEST_CASE(many_where_they_move_the_process)
{
  const auto outcome = run(peels);
  BOOST_TEST(outcome.with_few > 0u);
  BOOST_TEST(outcome.with_few < 100u);
}

BOOST_AUTO_TEST_CASE(many_where_searches_come_to_an_end)
{
  // The usual case. Nothing is tried, even if few would be cheaper.
  const auto outcome = run([](const bool few, double) { return Increment{few ? 10. : 1., 50, true}; });
  BOOST_TEST(outcome.with_few == 0u);
  // Nor where what is in vain is less than the iterations cost.
  const auto rare = run([](const bool few, double) { return Increment{few ? 10. : 1., 15, false}; });
  BOOST_TEST(rare.with_few == 0u);
}

BOOST_AUTO_TEST_CASE(a_process_that_gets_harder_is_no_reason)
{
  for (const double change : {.1, 10.})
  {
    const auto with_change = [change](const auto &process) {
      return [=](const bool few, const double share) {
        auto increment = process(few, share);
        increment.length *= std::pow(change, share);
        return increment;
      };
    };
    BOOST_TEST(run(with_change(endless)).with_few > 800u);
    BOOST_TEST(run(with_change(peels)).with_few < 100u);
  }
}

BOOST_AUTO_TEST_CASE(it_follows_a_process_that_changes)
{
  SetLimit limit;
  run(limit, endless, 300);
  BOOST_TEST(limit.most() == SetLimit::few);
  const auto outcome = run(limit, peels, 1000);
  BOOST_TEST(outcome.with_many > 500u);
  BOOST_TEST(limit.most() == SetLimit::many);
}

BOOST_AUTO_TEST_CASE(what_stays_is_tried_again_ever_less_often)
{
  SetLimit limit;
  const auto first = run(limit, peels, 500), later = run(limit, peels, 500), last = run(limit, peels, 640);
  BOOST_TEST(first.with_few >= 2 * later.with_few);
  BOOST_TEST(last.with_few > 0u);
}

BOOST_AUTO_TEST_CASE(sets_of_failed_attempts_count)
{
  SetLimit limit;
  for (unsigned int k = 0; k < 30; ++k)
  {
    limit.met(SetLimit::many, false); // of an attempt that failed
    limit.met(2, true);
    limit.accept(1., iterations);
  }
  BOOST_TEST(limit.most() == SetLimit::few); // the first comparison has begun
}

BOOST_AUTO_TEST_SUITE_END()
