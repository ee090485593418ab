#include <deltaform/materials/point_history.h>

#include <boost/test/unit_test.hpp>

#include <string>

using namespace deltaform;

namespace
{
  const HistoryLayout two_scalars{{"a", HistoryKind::scalar, "1"}, {"b", HistoryKind::positive, "1"}};
  const HistoryLayout plastic{{"strain", HistoryKind::tensor, "1"}, {"length", HistoryKind::positive, "1"}};
} // namespace

BOOST_AUTO_TEST_SUITE(point_history)

BOOST_AUTO_TEST_CASE(commit_and_rollback)
{
  PointHistory history(3, two_scalars);
  BOOST_TEST(history.committed(2)[1] == 0.);
  history.trial(2)[1] = 7.;
  BOOST_TEST(history.committed(2)[1] == 0.);
  history.commit();
  BOOST_TEST(history.committed(2)[1] == 7.);
  BOOST_TEST(history.committed(0)[5] == 7.); // points follow each other
  history.trial(2)[1] = 9.;
  history.rollback();
  BOOST_TEST(history.committed(2)[1] == 7.);
  BOOST_TEST(history.trial(2)[1] == 7.);
}

BOOST_AUTO_TEST_CASE(is_part_of_a_state)
{
  PointHistory history(2, plastic), other(2, plastic);
  history.trial(1)[4] = .1;
  history.commit();
  history.trial(0)[0] = .3;
  KeyedArrays state;
  PointHistory::each_array(history, PutInto(state));
  PointHistory::each_array(other, TakeFrom(state));
  BOOST_TEST(other.committed(1)[4] == .1);
  BOOST_TEST(other.trial(0)[0] == .3);
}

BOOST_AUTO_TEST_CASE(another_law_does_not_load_it)
{
  const PointHistory history(2, plastic);
  PointHistory other(2, two_scalars);
  KeyedArrays state;
  PointHistory::each_array(history, PutInto(state));
  BOOST_CHECK_EXCEPTION(PointHistory::each_array(other, TakeFrom(state)), SceneError, [](const SceneError &error) {
    return std::string(error.what()).find("a:scalar b:positive") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(layouts_follow_each_other)
{
  HistoryLayout layout = plastic;
  layout.append(plastic);
  layout.append(two_scalars);
  BOOST_TEST(layout.size() == 12u);
  const std::vector<unsigned int> expected = {0, 4, 5, 9, 10, 11};
  BOOST_TEST_REQUIRE(layout.fields().size() == expected.size());
  for (unsigned int i = 0; i < expected.size(); ++i)
    BOOST_TEST(layout.fields()[i].first == expected[i]);
  BOOST_TEST(plastic.to_string() == "strain:tensor length:positive");
}

BOOST_AUTO_TEST_CASE(positive_fields_stay_in_their_range)
{
  const double from[] = {0., 2.}, to[] = {-50., -2.}, least[] = {0., 1.}, most[] = {0., 3.};
  BOOST_TEST(two_scalars.share_within(from, to, least, most) == .25, boost::test_tools::tolerance(1e-13));
  const double inside[] = {-50., 2.5};
  BOOST_TEST(two_scalars.share_within(from, inside, least, most) == 1.);
  double negative[] = {-1., -1.};
  two_scalars.clip(negative);
  BOOST_TEST(negative[0] == -1.);
  BOOST_TEST(negative[1] == 0.);
}

BOOST_AUTO_TEST_CASE(nothing_to_remember)
{
  PointHistory history(10, HistoryLayout());
  history.commit();
  history.rollback();
  BOOST_TEST(history.committed(9) == history.committed(0));
}

BOOST_AUTO_TEST_SUITE_END()
