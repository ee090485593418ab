#pragma once

#include "material_points.h"
#include "solid_points.h"

#include <deltaform/materials/material.h>

#include <array>
#include <vector>

namespace deltaform
{
  /// A rotation in the plane, by cosine and sine of twice its angle, as it turns a stress.
  struct Turn
  {
    double cosine = 1, sine = 0;

    Mandel operator()(const Mandel &t) const;
  };


  /// The largest changes of the points of this process in an increment.
  struct SolidIncrementSize
  {
    double strain = 0, rotation = 0; ///< as in IncrementSize
    unsigned int strained = 0, turned = 0; ///< the points with these values
  };


  /**
   * How the points of a solid have moved, at the begin (committed) and at the end (trial) of an increment, and what of
   * it has become of their elastic and their plastic strain: doc/theory/solid.md.
   */
  class SolidMotion
  {
  public:
    /// @p finite: large strain; if not, the axes of the material never turn
    explicit SolidMotion(const bool finite)
      : finite_(finite)
    {
    }

    /// @p n points that never moved. @p remembers_turns: of the last increment, for flow that is carried on
    void reset(std::size_t n, bool remembers_turns);

    bool finite() const
    {
      return finite_;
    }

    /// Deformation gradient of the trial state; whoever assembles sets it.
    Deformation &now(const std::size_t point)
    {
      return deformation_[point];
    }
    const Deformation &now(const std::size_t point) const
    {
      return deformation_[point];
    }

    /// From the committed to the trial state.
    Deformation increment(std::size_t point) const;

    /// By how much that turns the axes of the material.
    Turn turn(std::size_t point) const;

    /// From the committed to the trial state.
    SolidIncrementSize increment_size() const;

    /// The same where only small displacements from the begin are known, and no strain is too large.
    static SolidIncrementSize increment_size(const SolidPoints &points, const Vector &du);

    /// Logarithmic strain ln(F F^T)/2, of small kinematics the symmetric part of the displacement gradient.
    Mandel strain(const Deformation &F) const;

    /// @name Committed flow; large strain only
    ///@{
    /// C_p^-1: rr, zz, hoop, rz.
    const std::array<double, 4> &plastic_metric(const std::size_t point) const
    {
      return plastic_metric_[point];
    }
    void set_plastic_metric(const std::size_t point, const std::array<double, 4> &metric)
    {
      plastic_metric_[point] = metric;
    }

    /// The logarithmic elastic strain in the trial state has the deviator of @p elastic: the rest is plastic.
    void flow_to(std::size_t point, Mandel elastic);

    /// Logarithmic plastic strain -ln(C_p^-1)/2, turned with the material by @p F.
    Mandel plastic_strain(std::size_t point, const Deformation &F) const;
    ///@}

    /// Volumetric strain without stress that a refinement left, in the projection.
    double volume_offset(const std::size_t point) const
    {
      return volume_offset_[point];
    }
    double &volume_offset(const std::size_t point)
    {
      return volume_offset_[point];
    }

    /// The increment to come is @p ratio times as long as the last one: the flow that @p material carries on turns as
    /// far as the points go on turning.
    void turn_flow(MaterialPoints &material, double ratio) const;

    /// The point has flowed or may have: keep by how much the increment has turned it.
    void remember_turn(const std::size_t point, const Turn &turn)
    {
      if (!turns_.empty())
        turns_[point] = turn;
    }

    /// Accept the trial state.
    void commit();

    /// The trial state is the accepted one, without an increment.
    void keep();

    /// Every array of the state with its name.
    template <typename Motion, typename Action>
    static void each_array(Motion &motion, const Action &action)
    {
      action("rotation of the last increment", motion.turns_);
      action("deformation", motion.committed_deformation_);
      action("plastic metric", motion.plastic_metric_);
      action("volumetric strain without stress", motion.volume_offset_);
    }

    /// The state was taken: the trial one is no other.
    void start_from_committed()
    {
      deformation_ = committed_deformation_;
    }

  private:
    bool finite_;
    std::vector<Turn> turns_; ///< of the last increment; of no points if nothing is carried on
    std::vector<Deformation> deformation_, committed_deformation_;
    std::vector<std::array<double, 4>> plastic_metric_;
    std::vector<double> volume_offset_;
  };
} // namespace deltaform
