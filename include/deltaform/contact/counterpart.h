#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/types.h>
#include <deltaform/geometry/curve.h>

#include <memory>

namespace deltaform
{
  class PointRows;
  class Tool;

  /**
   * What a side of the blank meets: a rigid profile, and what moves it. Contact asks it for closest points and for the
   * columns of the unknowns that move them; it knows nothing of the blank's points or of the laws of contact. Its
   * motion is a translation. One that turns or deforms would also have to tell how its normal changes.
   */
  class Counterpart
  {
  public:
    static constexpr unsigned int max_unknowns = 2;

    virtual ~Counterpart() = default;

    /// Along which points slide; places of it are arc lengths.
    virtual const Curve &profile() const = 0;

    /// Closest point to @p x, which is relative to the counterpart: the place in the scene less way(). See
    /// Tool::project() for the directions and @p hint.
    virtual Projection project(const Point2 &x, unsigned int hint = invalid_index) const = 0;

    /// How far it has gone since it was in its first place, at the unknowns @p q and @p time (length).
    virtual Tensor1 way(const Vector &q, double time) const = 0;

    /// @name Unknowns of its own, if it has any
    ///@{
    virtual unsigned int n_unknowns() const
    {
      return 0;
    }

    /// Their numbers begin with @p first.
    void set_first_unknown(const DofIndex first)
    {
      first_unknown_ = first;
    }

    DofIndex first_unknown() const
    {
      return first_unknown_;
    }

    /// Change of way() in the step @p d of the unknowns.
    virtual Tensor1 motion(const Vector & /*d*/) const
    {
      return Tensor1();
    }

    /// Add their columns to those of a contact point.
    virtual void add_columns(PointRows & /*rows*/) const
    {
    }

    /// Add what acts on them besides contact, at @p q and @p time.
    virtual void add_load(const Vector & /*q*/, double /*time*/, AssemblyTarget & /*target*/) const
    {
    }
    ///@}

  private:
    DofIndex first_unknown_ = dealii::numbers::invalid_dof_index;
  };


  /// A tool with a motion has no unknown, one under a force its travel.
  std::unique_ptr<Counterpart> make_counterpart(const Tool &tool);
} // namespace deltaform
