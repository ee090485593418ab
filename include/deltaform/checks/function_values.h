#pragma once

#include <deltaform/stage/actors.h>
#include <deltaform/stage/stage.h>

#include <optional>
#include <string>

namespace deltaform
{
  /// A function of the scene whose value at some time cannot be used.
  struct WrongValue
  {
    std::string section, name; ///< where its entry stands: "Tools", "punch"; no name: in the section itself
    std::string entry;
    std::string message; ///< with time and value

    /// "Tools/punch/Motion is ...".
    std::string to_string() const;
  };

  /**
   * Judges every function of time that a stage uses, at one time: motions, forces, prescribed displacements and loads
   * must be finite, forces press, allowed penetrations and elastic slips are positive and above round-off. A scene is
   * judged at samples before it runs, and a run at the end of every increment before it is tried, because what lies
   * between samples is known only then.
   */
  class FunctionValues
  {
  public:
    /// Of @p actors with the undeformed blank; they must live longer.
    explicit FunctionValues(const Actors &actors);

    /// The first value that is wrong at @p time of @p stage; nothing if all are right.
    std::optional<WrongValue> find_wrong(const Stage &stage, double time) const;

  private:
    std::optional<WrongValue> wrong_contact(const Stage &stage, double time) const;

    /// The allowed penetration of a tool.
    std::optional<WrongValue> wrong_delta(const Tool &tool, double time) const;

    /// What sticking friction needs, unless its factor is given.
    std::optional<WrongValue> wrong_slip(double time) const;

    const Actors &actors_;
    double size_; ///< largest distance of the blank from the origin, at least its thickness
  };
} // namespace deltaform
