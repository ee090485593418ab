#pragma once

#include <deltaform/assembly/term.h>
#include <deltaform/blanks/blank.h>
#include <deltaform/loads/arc_length.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/skipped_time.h>
#include <deltaform/parameters/time_function.h>

#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /// Entry Value of a kind of load: the unit and the sentence of its size, and what it works on.
  struct LoadWords
  {
    std::string unit, sentence;
    std::string way = {}; ///< what may be prescribed instead of its size: "volume", "displacement"; empty: nothing
  };

  /**
   * A load on the blank: forces f(q) per unit load times its size, which is Value(t). Where it is driven by what it
   * works on or by the length of the path (Control), Value(t) is that way or length, and the size is an unknown: see
   * LoadWay, ArcLength. Each kind is a file in
   * source/loads that registers itself under the name that the entry Kind gives; it reads its own entries from
   * the load's section.
   */
  class Load : public Term
  {
  public:
    /// Read the entries that all loads have.
    Load(Section &section, const Blank &blank, const LoadWords &words);

    /// Of the section, by which results and messages call the load.
    const std::string &name() const
    {
      return name_;
    }

    const TimeFunction &value() const
    {
      return value_;
    }

    /// What the run has skipped: the value goes on from where it was.
    void skip(const SkippedTime &skipped)
    {
      skipped_ = skipped;
    }

    /// Is the way, or the length of the path, prescribed and the size an unknown?
    bool follows_way() const
    {
      return follows_way_;
    }

    /// @name Of a load that follows a way: the unknown of its size
    ///@{
    void set_unknown(const DofIndex unknown)
    {
      unknown_ = unknown;
    }

    DofIndex unknown() const
    {
      return unknown_;
    }

    /// Sum of the absolute forces of a unit load on the undeformed blank of @p n unknowns.
    double unit_force(unsigned int n) const;
    ///@}

    /// In the state @p q at @p time: Value, or the unknown.
    double size(const Vector &q, const double time) const
    {
      return follows_way_ ? q[unknown_] : skipped_.value(value_, time);
    }

    /// In which the load acts; none stands for all.
    const std::vector<std::string> &stages() const
    {
      return stages_;
    }

    bool acts_in(const std::string &stage) const;

    /// Is it controlled by the length of a path, of which the nodes stay the same?
    bool follows_path() const
    {
      return path_.has_value();
    }

    Status assemble(const Vector &q, double time, AssemblyTarget &target) const override;

    void accept(const Vector &q, const double time, double /*duration*/) override
    {
      if (path_)
        path_->accept(q, skipped_.value(value_, time));
    }

    /// Add the forces of a load of the size @p value at @p q, with their sign in the residual.
    virtual void add(const Vector &q, double value, AssemblyTarget &target) const = 0;

    /// The blank was refined: its unknowns have new numbers.
    virtual void renumber()
    {
    }

    /// @name Of a load that remembers what it has met: its forces depend on its history
    ///@{
    /// Accepted; empty: it remembers nothing.
    virtual std::vector<double> history() const
    {
      return path_ ? path_->history() : std::vector<double>();
    }

    virtual void set_history(const std::vector<double> &values)
    {
      if (path_)
        path_->set_history(values);
    }

    /// It begins to act, in the accepted state @p q.
    virtual void begin(const Vector &q)
    {
      if (path_)
        path_->begin(q);
    }
    ///@}

    /// @name Of a load that also pushes a tool under a force off the blank
    ///@{
    /// Its name; empty: there is none.
    virtual std::string lifted_tool() const
    {
      return "";
    }

    /// By what force, against that of the tool.
    virtual double lift(const double /*time*/) const
    {
      return 0.;
    }

    void set_tool_unknown(const DofIndex unknown)
    {
      tool_unknown_ = unknown;
    }
    ///@}

    /// Of a draw bead: what it does to the sheet, accepted.
    struct Restraint
    {
      double force; ///< per length of the bead, positive against a sheet that is drawn towards its start
      double path; ///< length of undeformed sheet that has passed, to and fro
      double work; ///< of the sheet against the bead
    };
    virtual std::optional<Restraint> restraint() const
    {
      return std::nullopt;
    }

    /// The face on which it is a pressure, shown in pictures; empty: it is none.
    virtual std::string pressed_face() const
    {
      return "";
    }

  private:
    std::string name_;
    TimeFunction value_;
    SkippedTime skipped_;
    std::optional<ArcLength> path_; ///< whose length is prescribed
    bool follows_way_;
    bool is_mean_; ///< is the way a mean displacement, the work over the unit force?
    std::vector<std::string> stages_;
    DofIndex unknown_ = invalid_index;
    DofIndex tool_unknown_ = invalid_index; ///< travel of the lifted tool
  };

  /// Kinds of loads; their makers are also told the blank.
  using LoadRegistry = Registry<Load, const Blank &>;
} // namespace deltaform
