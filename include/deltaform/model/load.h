#pragma once

#include <deltaform/blanks/blank.h>
#include <deltaform/model/term.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/time_function.h>

#include <string>
#include <vector>

namespace deltaform
{
  /**
   * A load on the blank: forces f(q) per unit load times Value(t). Each kind is a file in source/model/loads that
   * registers itself under the name that the entry Kind gives; it reads its own entries from the load's section.
   */
  class Load : public Term
  {
  public:
    /// Read the entries that all loads have. @param unit, sentence of the entry Value
    Load(Section &section, const Blank &blank, const std::string &unit, const std::string &sentence);

    /// Of the section, by which results and messages call the load.
    const std::string &name() const
    {
      return name_;
    }

    const TimeFunction &value() const
    {
      return value_;
    }

    /// In which the load acts; none stands for all.
    const std::vector<std::string> &stages() const
    {
      return stages_;
    }

    bool acts_in(const std::string &stage) const;

    Status assemble(const Vector &q, double time, AssemblyTarget &target) override;

    /// Add the forces of a load of the size @p value at @p q, with their sign in the residual. Entries of the tangent
    /// couple unknowns of one cell at most.
    virtual void add(const Vector &q, double value, AssemblyTarget &target) const = 0;

    /// The blank was refined: its unknowns have new numbers.
    virtual void renumber()
    {
    }

    /// The face on which it is a pressure, shown in pictures; empty: it is none.
    virtual std::string pressed_face() const
    {
      return "";
    }

  private:
    std::string name_;
    TimeFunction value_;
    std::vector<std::string> stages_;
  };

  /// Kinds of loads; their makers are also told the blank.
  using LoadRegistry = Registry<Load, const Blank &>;
} // namespace deltaform
