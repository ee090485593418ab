#include <deltaform/conditions/conditions.h>
#include <deltaform/io/byte_stream.h>

#include <sstream>

namespace deltaform
{
  Conditions::Conditions(const Actors &actors)
  {
    for (const auto &name : ConditionMakers::names())
      all_.push_back(ConditionMakers::make(name, actors));
  }


  void Conditions::observe(const AcceptedIncrement &increment)
  {
    for (const auto &condition : all_)
      condition->observe(increment);
  }


  std::string Conditions::failure(const Stage &stage)
  {
    // Each is asked: one that lets the run go on remembers what it has passed over.
    std::string first;
    for (const auto &condition : all_)
      if (const std::string failure = condition->failure(stage); first.empty())
        first = failure;
    return first;
  }


  std::string Conditions::stage_end(const Stage &stage) const
  {
    for (const auto &condition : all_)
      if (std::string end = condition->stage_end(stage); !end.empty())
        return end;
    return "";
  }


  std::string Conditions::likely_cause(const std::vector<SheetSection> &refused) const
  {
    for (const auto &condition : all_)
      if (std::string cause = condition->likely_cause(refused); !cause.empty())
        return cause;
    return "";
  }


  std::vector<std::string> Conditions::warnings(const bool done) const
  {
    std::vector<std::string> result;
    for (const auto &condition : all_)
      for (auto &warning : condition->warnings(done))
        result.push_back(std::move(warning));
    return result;
  }


  std::string Conditions::save() const
  {
    ByteStream bytes;
    {
      boost::archive::binary_oarchive archive(bytes.stream());
      for (const auto &condition : all_)
        condition->save(archive);
    }
    return bytes.take();
  }


  void Conditions::load(const std::string &bytes)
  {
    std::istringstream stream(bytes);
    boost::archive::binary_iarchive archive(stream);
    for (const auto &condition : all_)
      condition->load(archive);
  }
} // namespace deltaform
