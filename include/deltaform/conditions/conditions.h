#pragma once

#include <deltaform/conditions/condition.h>
#include <deltaform/parameters/makers.h>
#include <deltaform/stage/actors.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace deltaform
{
  /// A condition that is saved by its member serialize(), as Boost has it: template <class Archive> void
  /// serialize(Archive &archive, unsigned int).
  template <typename Own>
  class SavedCondition : public Condition
  {
  public:
    void save(boost::archive::binary_oarchive &archive) const override
    {
      archive << static_cast<const Own &>(*this);
    }

    void load(boost::archive::binary_iarchive &archive) override
    {
      archive >> static_cast<Own &>(*this);
    }
  };

  /// Conditions by their names; makers are told the actors. The last line of a condition's file is an Entry.
  using ConditionMakers = Makers<Condition, const Actors &>;

  /// Makes a condition, from the actors if it wants to know them.
  template <typename Own>
  std::unique_ptr<Condition> make_condition(const Actors &actors)
  {
    if constexpr (std::is_constructible_v<Own, const Actors &>)
      return std::make_unique<Own>(actors);
    else
    {
      (void) actors;
      return std::make_unique<Own>();
    }
  }

  /// All conditions of a run.
  class Conditions
  {
  public:
    /// Every one that is registered, in the order of their names.
    explicit Conditions(const Actors &actors);

    void observe(const AcceptedIncrement &increment);

    /// Why the result cannot be used from here on; empty if it can.
    std::string failure(const Stage &stage);

    /// Why the stage is over before its time; empty if it is not.
    std::string stage_end(const Stage &stage) const;

    /// See Condition::likely_cause().
    std::string likely_cause(const std::vector<SheetSection> &refused = {}) const;

    /// See Condition::warnings().
    std::vector<std::string> warnings(bool done) const;

    /// What they remember, in bytes that only they understand.
    std::string save() const;
    void load(const std::string &bytes);

  private:
    std::vector<std::unique_ptr<Condition>> all_;
  };
} // namespace deltaform
