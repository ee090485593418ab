#pragma once

#include <deltaform/io/archive_fwd.h>

#include <string>
#include <vector>

namespace deltaform
{
  class AcceptedIncrement;
  struct SheetSection;
  struct Stage;

  /**
   * Looks at the accepted increments of a run and says what an engineer should know of its result: why it cannot be
   * used any further, which ends the run, or what makes it doubtful, each with what to do about it. One idea each.
   */
  class Condition
  {
  public:
    virtual ~Condition() = default;

    virtual void observe(const AcceptedIncrement &increment) = 0;

    /// Why the result cannot be used from here on; empty if it can.
    virtual std::string failure(const Stage & /*stage*/)
    {
      return "";
    }

    /// Why @p stage is over before its time; empty if it is not. The run goes on with the next stage.
    virtual std::string stage_end(const Stage & /*stage*/) const
    {
      return "";
    }

    /// What may be the cause that the next increment could not be solved; empty if nothing is known. @param refused
    /// cross-sections of the sheet in the equilibrium that was refused for its strain; none if that was not the reason
    virtual std::string likely_cause(const std::vector<SheetSection> & /*refused*/) const
    {
      return "";
    }

    /// What makes the result of a run doubtful that has ended. @param done it has, else it stopped
    virtual std::vector<std::string> warnings(bool /*done*/) const
    {
      return {};
    }

    virtual void save(boost::archive::binary_oarchive &archive) const = 0;
    virtual void load(boost::archive::binary_iarchive &archive) = 0;
  };
} // namespace deltaform
