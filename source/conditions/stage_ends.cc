#include <deltaform/conditions/stage_ends.h>
#include <deltaform/io/byte_stream.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/quantities.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    constexpr double closeness = 1e-3; ///< of a limit: so near to it, it is met
    /// A number of nodes comes and goes by whole steps: nothing is near it, and nothing foretells it.
    bool is_count(const std::string &quantity)
    {
      const std::string ending = "_touching";
      return quantity.size() > ending.size() && quantity.substr(quantity.size() - ending.size()) == ending;
    }

    constexpr double shortest_share = .02; ///< of the last increment, that one before a limit may have
  } // namespace


  StageEnds::StageEnds(const Actors &actors)
    : quantities_(quantities(actors))
  {
  }


  StageEnds::Criterion StageEnds::parse_one(const std::string &text) const
  {
    std::istringstream words(text);
    Criterion result{text, "", Kind::above, 0.};
    std::string relation, to;
    words >> result.quantity >> relation;
    if (relation == "falls")
      words >> to;
    result.kind = relation == ">" ? Kind::above : relation == "<" ? Kind::below
                                                                  : Kind::falls_to;
    const bool understood = (relation == ">" || relation == "<" || (relation == "falls" && to == "to")) &&
                            (words >> result.limit) && (words >> std::ws).eof();
    if (!understood)
      throw std::invalid_argument("'" + text + "' is not understood: a condition reads '<quantity> > <number>', "
                                               "'<quantity> < <number>' or '<quantity> falls to <share>'");
    if (result.kind == Kind::falls_to && !(result.limit > 0. && result.limit < 1.))
      throw std::invalid_argument("'" + text + "': the share of the largest size lies between 0 and 1");
    std::vector<std::string> names;
    for (const auto &column : quantities_.columns())
      names.push_back(column.name);
    if (std::find(names.begin(), names.end(), result.quantity) == names.end())
      throw std::invalid_argument("there is no quantity '" + result.quantity + "'; the nearest is '" +
                                  text::nearest(result.quantity, names) + "', and there are " +
                                  text::join(names, ", "));
    return result;
  }


  std::vector<StageEnds::Criterion> StageEnds::parse(const std::string &text) const
  {
    std::vector<Criterion> result;
    for (const auto &piece : text::split(text, ';'))
      result.push_back(parse_one(piece));
    return result;
  }


  void StageEnds::check(const Stage &stage) const
  {
    parse(stage.ends_when);
  }


  void StageEnds::enter_stage(const Stage &stage)
  {
    criteria_ = parse(stage.ends_when);
    if (stage_ == stage.name && watched_.size() == criteria_.size())
      return;
    stage_ = stage.name;
    watched_.assign(criteria_.size(), Watched());
    reached_.clear();
  }


  void StageEnds::observe(const AcceptedIncrement &increment)
  {
    if (criteria_.empty())
      return;
    const Columns::Row row = quantities_.row(increment);
    for (std::size_t i = 0; i < criteria_.size(); ++i)
    {
      std::size_t column = 0;
      while (quantities_.columns()[column].name != criteria_[i].quantity)
        ++column;
      const double *const value = std::get_if<double>(&row[column]);
      if (value == nullptr)
        continue;
      Watched &watched = watched_[i];
      // Over one of the short increments before a limit, what happens at its end outweighs the rate: the thickness is
      // updated, a contact point comes or goes.
      if (!watched.known)
        watched.from_time = increment.time;
      else if (increment.time - watched.time >= .5 * (watched.time - watched.from_time))
      {
        watched.from_time = watched.time;
        watched.from_value = watched.value;
      }
      watched.time = increment.time;
      watched.value = *value;
      watched.largest = std::max(watched.largest, std::abs(*value));
      watched.known = true;
      if (reached_.empty() && holds(criteria_[i], watched))
        reached_ = criteria_[i].text + " (it is " + text::rounded(*value) + ")";
    }
  }


  double StageEnds::bound(const Criterion &criterion, const Watched &watched)
  {
    return criterion.kind == Kind::falls_to ? criterion.limit * std::copysign(watched.largest, watched.value)
                                            : criterion.limit;
  }


  bool StageEnds::holds(const Criterion &criterion, const Watched &watched)
  {
    const double tolerance = is_count(criterion.quantity) ? 0. : closeness * std::abs(criterion.limit);
    switch (criterion.kind)
    {
    case Kind::above:
      return watched.value > criterion.limit - tolerance;
    case Kind::below:
      return watched.value < criterion.limit + tolerance;
    default:
      return std::abs(watched.value) < (1. + closeness) * criterion.limit * watched.largest;
    }
  }


  double StageEnds::shorten(const double next) const
  {
    double result = next;
    for (std::size_t i = 0; i < criteria_.size(); ++i)
      if (const Watched &watched = watched_[i];
          watched.rate() != 0. && !is_count(criteria_[i].quantity))
      {
        const double left = (bound(criteria_[i], watched) - watched.value) / watched.rate();
        if (left > 0.)
          result = std::min(result, watched.time + std::max(left, shortest_share * (next - watched.time)));
      }
    return result;
  }


  std::string StageEnds::save() const
  {
    ByteStream bytes;
    {
      boost::archive::binary_oarchive archive(bytes.stream());
      archive << stage_ << watched_ << reached_;
    }
    return bytes.take();
  }


  void StageEnds::load(const std::string &bytes)
  {
    std::istringstream stream(bytes);
    boost::archive::binary_iarchive(stream) >> stage_ >> watched_ >> reached_;
  }
} // namespace deltaform
