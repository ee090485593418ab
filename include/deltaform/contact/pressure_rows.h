#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/contact/point_rows.h>

#include <array>

namespace deltaform
{
  /// What the mean pressure of an edge adds to the tangent: the friction of each point changes with it, and the normal
  /// force of each changes it. A product of a column and a row (doc/theory/friction.md).
  class PressureRows
  {
  public:
    /// The points of an edge follow.
    void begin()
    {
      n_ = 0;
    }

    /// Of a touching point with the unknowns of @p rows, whose force changes by @p force_rate with the pressure, and
    /// whose place changes the pressure by @p by_place.
    void add(const PointRows &rows, const Tensor1 &force_rate, const Tensor1 &by_place);

    void add_to(AssemblyTarget &target) const;

  private:
    static constexpr unsigned int most = PointRows::most;

    /// Row of an unknown. The points of an edge have the same ones, in any order.
    unsigned int row(DofIndex dof);

    unsigned int n_ = 0;
    std::array<DofIndex, most> dofs_;
    std::array<double, most> column_; ///< d residual / d pressure
    std::array<double, most> row_; ///< d pressure / d unknown
  };
} // namespace deltaform
