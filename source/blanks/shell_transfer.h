#pragma once

#include "material_points.h"
#include "shell_points.h"
#include "shell_space.h"

#include <deltaform/io/keyed_arrays.h>

#include <vector>

namespace deltaform
{
  /**
   * From a formed shell to another mesh on the same undeformed meridian, or on a part of it: that of a later operation,
   * or a finer one. Between two nodes the formed meridian is the cubic with their directors' normals as tangents, as
   * contact sees it, so that nodes of a finer mesh lie on it without shear. What is known at points is interpolated
   * linearly over the initial arc length, layer by layer. The plastic strain is then corrected by what the strain of
   * the new mesh differs from the interpolated one, so that the stress is the interpolated one.
   */
  class ShellTransfer
  {
  public:
    /// How a point of this mesh finds itself on the other one.
    enum class Correspondence : unsigned char
    {
      place, ///< undeformed: the meridian may begin elsewhere
      arc_length ///< the meridian is the same
    };

    ShellTransfer(const ShellSpace &space, const ShellPoints &points, const MaterialPoints &material,
                  const Correspondence by)
      : space_(space), points_(points), material_(material), by_(by)
    {
    }

    /// Where the state of this mesh is known, for another one.
    void describe(const Vector &q, KeyedArrays &formed) const;

    /// The unknowns @p q on this mesh. @throws SceneError if it is no part of the meridian that was formed
    void set_unknowns(const KeyedArrays &formed, Vector &q) const;

    /// The state on this mesh. @param own it has the right arrays; what the formed one has is replaced
    /// @param q what set_unknowns() gave
    void set_state(const KeyedArrays &formed, const Vector &q, KeyedArrays &own) const;

  private:
    /// Between two neighbouring nodes: arc lengths, places before and after, angles of the formed tangent.
    struct Interval
    {
      double s[2], before[2][2], after[2][2], angle[2];
    };

    struct Place
    {
      std::size_t interval;
      double share; ///< of the way from its start to its end
      double arc_length;
    };

    static std::vector<Interval> intervals_of(const KeyedArrays &formed);
    Place find(const std::vector<Interval> &intervals, const Point2 &X, double arc_length) const;
    Place find_place(const std::vector<Interval> &intervals, const Point2 &X) const;
    static Place find_arc_length(const std::vector<Interval> &intervals, double arc_length);
    std::vector<double> arc_lengths_of_points() const;
    Point2 place_of_point(unsigned int point) const;
    void keep_stress(const Vector &q, KeyedArrays &own) const;

    const ShellSpace &space_;
    const ShellPoints &points_;
    const MaterialPoints &material_;
    Correspondence by_;
  };
} // namespace deltaform
