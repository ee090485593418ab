#pragma once

#include <deltaform/model/actors.h>
#include <deltaform/model/condition.h>

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

  /// Registers a condition by its name; the last line of the file that defines it.
  class ConditionEntry
  {
  public:
    using Maker = std::unique_ptr<Condition> (*)(const Actors &actors);

    /// @throws std::logic_error if the name is taken
    ConditionEntry(const std::string &name, Maker make);
  };

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

  /// Every condition there is, by the order of their names.
  std::vector<std::unique_ptr<Condition>> make_conditions(const Actors &actors);
} // namespace deltaform
