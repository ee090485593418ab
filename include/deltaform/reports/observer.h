#pragma once

#include <deltaform/assembly/types.h>
#include <deltaform/io/archive_fwd.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/reports/checkpoint.h>

#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  class AcceptedIncrement;
  class Model;
  class System;
  struct Stage;

  /// How a run has ended.
  struct RunOutcome
  {
    int exit_status;
    std::string message; ///< why it stopped; empty if it is done
    std::vector<std::string> warnings; ///< what makes input or result doubtful
    unsigned int increments, iterations;
    std::optional<Checkpoint> state; ///< of a run that has stopped, what it can go on from; none: the last one saved

    /// Neither done nor interrupted: results of its last increment are written.
    bool stopped_by_itself() const
    {
      return exit_status != exit_status::done && !exit_status::interrupted(exit_status);
    }
  };

  /// Sees the accepted states of a run, writes or shows them. What is not asked for is not there, and costs nothing.
  class Observer
  {
  public:
    virtual ~Observer() = default;

    /// Observers are told in the order of their turns.
    enum class Turn : unsigned char
    {
      measures, ///< what others report
      writes,
      sums_up, ///< what was written
      saves ///< a state, from which a run goes on with all that was written
    };

    virtual Turn turn() const
    {
      return Turn::writes;
    }

    /// The first stage begins, with the undeformed blank and the tools at their start.
    virtual void begin(const Model & /*model*/, const Stage & /*stage*/)
    {
    }

    /// An increment will be tried, perhaps more than once.
    virtual void before(const Model & /*model*/, unsigned int /*number*/)
    {
    }

    /// Asked after before(): does it want the tangent without contact of every assembly of this increment?
    virtual bool wants_tangent() const
    {
      return false;
    }

    /// That tangent: terms of the body and the loads, and not yet those of contact.
    virtual void tangent_without_contact(const System & /*system*/)
    {
    }

    /// It is solved, by the unknowns @p q, and will be accepted; @p system is that of the last assembly.
    virtual void solved(const Model & /*model*/, const System & /*system*/, const Vector & /*q*/)
    {
    }

    virtual void accepted(const AcceptedIncrement & /*increment*/)
    {
    }

    /// The run goes on from a saved state, of which this was the last increment (number 0: there was none).
    virtual void resumed(const AcceptedIncrement & /*increment*/)
    {
    }

    /// The run has gone to another of its states, forwards or back, of which this was the last increment. What was
    /// written stays. Also before resumed().
    virtual void moved(const AcceptedIncrement & /*increment*/)
    {
    }

    /// The run is done: what was asked for and cannot be said, each with what to do about it. Before ended().
    virtual std::vector<std::string> missing(const Model & /*model*/) const
    {
      return {};
    }

    virtual void ended(const Model & /*model*/, const RunOutcome & /*outcome*/)
    {
    }

    /// What it cannot find out from the model when a run is resumed. load() comes before resumed().
    virtual void save(boost::archive::binary_oarchive & /*archive*/) const
    {
    }
    virtual void load(boost::archive::binary_iarchive & /*archive*/)
    {
    }
  };
} // namespace deltaform
