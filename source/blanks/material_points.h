#pragma once

#include "blank_account.h"
#include "metal_axes.h"
#include "point_criteria.h"

#include <deltaform/io/keyed_arrays.h>
#include <deltaform/materials/bdf2_predictor.h>
#include <deltaform/materials/material.h>
#include <deltaform/materials/point_history.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace deltaform
{
  class Section;

  /**
   * The points of a blank at which its law is evaluated, and what they carry through an increment: history, flow of the
   * last increment and stress, each at the begin (committed) and at the end (trial), strain at the end, and the
   * energies of all. How strains follow from displacements is the blank's affair.
   */
  class MaterialPoints
  {
  public:
    /// Read the law from the section Material beside @p blank.
    /// @throws SceneError if it cannot serve a blank of this symmetry that asks for @p third
    MaterialPoints(Section &blank, ThirdDirection third, bool axisymmetric);

    /// @p n points of the undeformed body; energies remain.
    void reset(std::size_t n);

    std::size_t size() const
    {
      return strain_.size();
    }

    const Material &law() const
    {
      return *law_;
    }

    /// Of an undeformed point; infinite if it is elastic.
    double initial_flow_stress() const;

    /// Can points flow?
    bool plastic() const
    {
      return law_->history_size() > 0;
    }

    /// @name Axes of the metal, for laws that have some in a solid
    ///@{
    /// Does the law know directions, or tensors that turn with the metal? Then the history is in the axes of the
    /// points, strain and stress are those of r and z.
    bool has_axes() const
    {
      return has_axes_;
    }

    void set_axes(const std::size_t point, const MetalAxes &axes)
    {
      axes_[point] = axes;
    }

    /// Derivative of the stress by the angle of the axes, of the last update() with a tangent.
    const Mandel &stress_by_angle(const std::size_t point) const
    {
      return stress_by_angle_[point];
    }

    /// A tensor of the committed history, in r and z.
    Mandel tensor(const std::size_t point, const HistoryField &field) const
    {
      const double *const values = history_.committed(point) + field.first;
      return in_space(point, {{values[0], values[1], values[2], values[3]}});
    }
    ///@}

    /// @name Trial state
    ///@{
    /// Logarithmic strain (Mandel), which the blank sets before update().
    Mandel &strain(const std::size_t point)
    {
      return strain_[point];
    }
    const Mandel &strain(const std::size_t point) const
    {
      return strain_[point];
    }
    const std::vector<Mandel> &strains() const
    {
      return strain_;
    }

    /// Stress and history of @p n points (a cell) from @p first on, by their strains. @param tangent n x 4 x 4 moduli,
    /// or null @param third_stress null if the strain of the third direction is given
    Status update(std::size_t first, unsigned int n, double *tangent, const double *third_stress = nullptr);

    /// What the present increment takes (time), see MaterialBatch::duration.
    double duration() const
    {
      return share_of_duration_ * duration_;
    }

    /// Kirchhoff stress (Mandel).
    const Mandel &stress(const std::size_t point) const
    {
      return stress_[point];
    }

    Mandel trial_plastic_strain(const std::size_t point) const
    {
      return in_space(point, law_->plastic_strain(history_.trial(point)));
    }

    /// Elastic energy per reference volume.
    double stored_energy(const std::size_t point) const
    {
      return law_->stored_energy(stress_[point], history_.trial(point));
    }

    /// What the increment dissipates by a change of the elasticity, per reference volume: 1/2 t_n : (change of C^-1) :
    /// t_n+1, the rest of the trapezoidal work t : de beside the stored energy and the work on the plastic strain.
    double dissipation_of_stiffness(std::size_t point) const;

    /// Growth of the equivalent plastic strain in this increment.
    double flow(const std::size_t point) const
    {
      return law_->equivalent_plastic_strain(history_.trial(point)) - equivalent_plastic_strain(point);
    }
    ///@}

    /// @name Committed state
    ///@{
    const Mandel &committed_stress(const std::size_t point) const
    {
      return committed_stress_[point];
    }

    Mandel plastic_strain(const std::size_t point) const
    {
      return in_space(point, law_->plastic_strain(history_.committed(point)));
    }

    double equivalent_plastic_strain(const std::size_t point) const
    {
      return law_->equivalent_plastic_strain(history_.committed(point));
    }

    double flow_stress(const std::size_t point) const
    {
      return law_->flow_stress(history_.committed(point));
    }

    /// Values of the law's history, by Material::history_layout().
    const double *history(const std::size_t point) const
    {
      return history_.committed(point);
    }
    ///@}

    /// @name Between increments
    ///@{
    /// The increment to come, see Blank::begin_increment(). @return is the last flow carried on?
    bool begin_increment(const double duration, const double ratio)
    {
      if (duration > 0.)
        duration_ = duration;
      share_of_duration_ = duration > 0. ? 1. : at_the_same_time;
      return predictor_.predict(ratio);
    }

    /// Does the law go on from the flow of the last increment?
    bool has_predictor() const
    {
      return predictor_.used();
    }

    /// What is measured at the points beside the history, committed.
    const PointCriteria &criteria() const
    {
      return *criteria_;
    }
    PointCriteria &criteria()
    {
      return *criteria_;
    }

    /// What is carried on of the last flow, by Material::history_layout(); null if nothing is.
    double *predictor(const std::size_t point)
    {
      return predictor_.at(point);
    }

    /// Accept the trial state.
    void commit();

    /// Change a value of the committed history; @p field has one.
    void set_value(const std::size_t point, const HistoryField &field, const double value)
    {
      history_.committed(point)[field.first] = value;
    }

    /// A history from elsewhere: @p values are those of all points. There is no flow to go on from.
    void set_history(const std::vector<double> &values);

    /// The trial stress is that of the accepted state, without an increment.
    void keep_stress()
    {
      committed_stress_ = stress_;
    }
    ///@}

    /// Energies of all points.
    ///@{
    const BlankAccount &account() const
    {
      return account_;
    }
    BlankAccount &account()
    {
      return account_;
    }
    ///@}

    /// Put the committed state into that of the blank, or take it from there.
    void put(KeyedArrays &state) const;
    void take(const KeyedArrays &state);

  private:
    Mandel in_space(const std::size_t point, const Mandel &t) const
    {
      return has_axes_ ? axes_[point].out_of(t) : t;
    }

    /// Of the increment that is accepted.
    void grow_criteria();

    /// update() in the axes of the points.
    Status update_in_axes(MaterialBatch batch, std::size_t first);

    /// Every array of the state with its name, but for the energies.
    template <typename Points, typename Action>
    static void each_array(Points &points, const Action &action)
    {
      PointHistory::each_array(points.history_, action);
      Bdf2Predictor::each_array(points.predictor_, action);
      action("stress", points.committed_stress_);
      PointCriteria::each_array(*points.criteria_, action);
      if (points.law_->traits().needs_duration)
        action("duration of the last increment", points.duration_);
    }

    std::unique_ptr<Material> law_;
    std::unique_ptr<PointCriteria> criteria_;
    bool has_axes_ = false;
    std::vector<MetalAxes> axes_; ///< of no points if there are none
    std::vector<Mandel> stress_by_angle_;
    ThirdDirection third_ = ThirdDirection::strain_given;
    PointHistory history_;
    /// Equilibrium is sought anew at the same time: so short that a rate-dependent flow stress does not relax.
    static constexpr double at_the_same_time = 1e-6;
    double duration_ = 1.; ///< of the last increment that took time (time)
    double share_of_duration_ = 1.; ///< of it, that the present one takes
    Bdf2Predictor predictor_; ///< of no points if the law does not want it
    std::vector<Mandel> strain_, stress_, committed_stress_;
    BlankAccount account_;
  };
} // namespace deltaform
