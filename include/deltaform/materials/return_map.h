#pragma once

#include <deltaform/materials/elasticity.h>
#include <deltaform/materials/hardening.h>
#include <deltaform/materials/history_layout.h>
#include <deltaform/materials/material.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  /// The history of every metal begins with the plastic strain (3x3, Mandel) and the equivalent plastic strain.
  struct FlowHistory
  {
    static constexpr unsigned int equivalent = 4; ///< place of the equivalent plastic strain
    static constexpr unsigned int size = 5;

    static HistoryLayout layout()
    {
      return {{"plastic_strain", HistoryKind::tensor, "1"}, {"equivalent_plastic_strain", HistoryKind::positive, "1"}};
    }
  };


  /// How a return map ended.
  enum class PointOutcome : unsigned char
  {
    good,
    not_finite,
    not_converged
  };


  /// What every return map must know of a metal.
  struct FlowLaw
  {
    const Elasticity &elastic;
    const Hardening &hardening;
    double initial_flow_stress; ///< hardening at no plastic strain
    double duration; ///< of the increment (time)
    double share; ///< of it, that flow from PointUpdate::start takes (Bdf2Predictor); 1: backward Euler
    /// Equivalent stress at the begin of the increment; infinite: not known, or no matter
    double first_stress = std::numeric_limits<double>::infinity();
  };


  /**
   * Round-off of the yield condition at the equivalent stress @p q of a trial stress. A point that has flowed lies on
   * its yield surface as closely as that. At rest it must not flow again, or the last digit decides which points of a
   * blank that is unloaded have a plastic tangent.
   *
   * The stress is computed from strain less plastic strain, which is stored with a relative error of epsilon/2, and
   * turned with the metal with another. Its last increment has nine of them (three each of the trial deviator, of its
   * size, of product and sum); it is taken for a quarter at most. The size of the plastic strain is at most sqrt(3/2)
   * times the equivalent one e, and q has a slope of at most 6 G/sqrt(2) in it (plane stress, both directions alike,
   * Poisson's ratio 1/2): together 11 G epsilon e. The solution of the yield condition (2e-15 to 1e-14) and the
   * evaluation of q add 1e-14 q.
   */
  inline double yield_round_off(const FlowLaw &law, const double *start, const double q)
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    return 1e-14 * q + 12. * law.elastic.shear * epsilon * start[FlowHistory::equivalent];
  }


  /// Is the yield condition violated by round-off alone? @p drop: by how much flow has brought @p q down. If that
  /// is more than round-off, the flow stress at the start is not evaluated.
  inline bool rests_on_surface(const FlowLaw &law, const double *start, const double q, const double drop)
  {
    const double round_off = yield_round_off(law, start, q);
    return drop <= round_off && q - law.hardening.evaluate(start[FlowHistory::equivalent]).value <= round_off;
  }


  /// One point of a MaterialBatch, as a return map sees it.
  struct PointUpdate
  {
    Mandel &strain; ///< total logarithmic strain; [2] is output where the third stress is given
    double third_stress; ///< Kirchhoff stress, where it is given
    const double *start; ///< history that backward Euler starts from
    const double *committed; ///< history at the begin of the increment
    double *trial; ///< in: a starting guess; out: history at this strain
    Mandel &stress; ///< out: Kirchhoff stress
    double *tangent; ///< out if not null: 4 x 4, row-major; at given third stress row and column [2] are zero
  };


  /// Backward Euler of one point, for one of the questions about the third direction.
  class ReturnMap
  {
  public:
    virtual ~ReturnMap() = default;

    virtual PointOutcome update(const FlowLaw &law, const PointUpdate &point) const = 0;
  };


  /// An elastic step: the history does not change.
  inline void keep_history(const double *start, double *trial, const unsigned int n = FlowHistory::size)
  {
    for (unsigned int i = 0; i < n; ++i)
      trial[i] = start[i];
  }


  /**
   * Equivalent plastic strain to be expected of this increment: that of the last iteration, or, just after a commit,
   * when the trial values are those of the increment before, the last increment's again.
   */
  inline double expected_increment(const double *start, const double *trial)
  {
    return std::abs(trial[FlowHistory::equivalent] - start[FlowHistory::equivalent]);
  }
} // namespace deltaform
