#pragma once

#include <deltaform/base/section.h>
#include <deltaform/base/status.h>
#include <deltaform/base/timers.h>
#include <deltaform/solver/system.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// What the Newton iteration needs to know of the problem: numbers, no physics.
  class NonlinearProblem
  {
  public:
    virtual ~NonlinearProblem() = default;

    /// A length of the problem (the thickness): displacements of 1 % of it are large enough to measure steps by.
    virtual double typical_length() const = 0;

    /// Residual, and tangent if wanted, at @p q into the system.
    virtual Status assemble(const Vector &q, bool tangent) = 0;

    /// Shorten components of the step @p d that nothing resists. @return the largest factor in (0, 1] of the step
    /// that is admissible from @p q
    virtual double limit_step(const Vector &q, Vector &d) const = 0;

    /// A step @p d was computed from the state that was assembled last.
    virtual void prepare_step(const Vector &d) = 0;

    /// It is taken by @p factor; the assembly at the new place follows.
    virtual void advance(double factor) = 0;

    /// Did the last assembly belong to another set of active constraints than the one before? Their residuals do not
    /// compare.
    virtual bool status_changed() const = 0;

    /// For how many iterations a residual may grow with a changed set before the line search is used all the same.
    virtual unsigned int patience() const = 0;

    /// Is the assembled state admissible as a solution if its residual is small enough? Contact forces may be tensile
    /// up to
    /// @p allowed_tension.
    virtual bool consistent(double allowed_tension) const = 0;

    /// From now on constraints with forces up to @p force need not change between active and inactive.
    virtual void allow_slack(double force) = 0;

    /// After convergence: @return how many parameters (penalty factors) were changed, so that the solve must go on.
    virtual unsigned int correct() = 0;
  };

  /// Tolerances and limits of the Newton iteration.
  struct NewtonSettings
  {
    explicit NewtonSettings(Section &section);

    unsigned int max_iterations;
    unsigned int max_rounds;
    double force_tolerance, relaxed_tolerance, displacement_tolerance;
    bool line_search;
  };

  /// What a Newton solve did.
  struct NewtonResult
  {
    enum class Outcome : unsigned char
    {
      converged,
      diverged,
      singular,
      inadmissible, ///< a status of the laws
      not_corrected ///< converged, but the corrections did not end
    };

    Outcome outcome = Outcome::diverged;
    unsigned int iterations = 0, rounds = 0, line_searches = 0;
    unsigned int correction_iterations = 0; ///< those after the first convergence: what the corrections cost
    Status status;
    unsigned int worst_dof = invalid_index; ///< largest share of the residual
    std::vector<double> residuals; ///< relative, of every iteration since the last correction

    bool converged() const
    {
      return outcome == Outcome::converged;
    }
  };

  /// For an increment in which the blank snaps through: where the step leads uphill, follow the motion of the blank in
  /// a viscous medium instead, to where it comes to rest. The solution is of the same equations; takes many more
  /// iterations.
  enum class Damping : unsigned char
  {
    none,
    damped,
    with_slack ///< and pairs that carry next to nothing need not decide whether they touch
  };

  /**
   * Newton's method with a line search on the work of the residual along the step, and rounds of corrections after
   * convergence. Converged: |R| <= tolerance * sum of absolute contributions, and the last step small against the
   * increment; rotations are scaled by the problem's length, so that both norms have one unit.
   */
  class Newton
  {
  public:
    /**
     * @param scale of every unknown: makes rotations comparable with displacements (scale * q) and moments with forces
     * (R / scale)
     * @param size  of the numbers from which the forces of an unknown are computed (coordinates, angles): its unit in
     * the last place times the stiffness is the round-off of the residual, below which nothing converges
     */
    Newton(NonlinearProblem &problem,
           System &system,
           const NewtonSettings &settings,
           const std::vector<double> &scale,
           const std::vector<double> &size,
           Timers &timers);

    /**
     * @param q          in: start; out: solution
     * @param prescribed values that prescribed unknowns must reach
     * @param is_prescribed which they are
     * @param q_committed start of the increment, for the scale of the displacements
     * @param force_floor forces below this are round-off
     */
    NewtonResult solve(Vector &q,
                       const Vector &prescribed,
                       const std::vector<bool> &is_prescribed,
                       const Vector &q_committed,
                       double force_floor,
                       Damping damped = Damping::none);

  private:
    /// Relative residual; remembers the worst unknown.
    double measure(const std::vector<bool> &is_prescribed, double force_floor, NewtonResult &result) const;

    /// d.R: what the residual does along a step.
    double work_along(const Vector &d, const std::vector<bool> &is_prescribed) const;

    /**
     * Pseudo-transient continuation: while @p d leads uphill (d.R > 0, the tangent K is indefinite), solve with K +
     * damping M instead, M the squares of the scales, which is a step of the implicit Euler method for M q' = -R of the
     * length 1/damping. C.T. Kelley, D.E. Keyes, Convergence analysis of pseudo-transient continuation, SIAM J. Numer.
     * Anal. 35 (1998) 508.
     * @return false if the matrix is singular
     */
    bool descend(const Vector &q, const std::vector<bool> &is_prescribed, const Vector &increments, Vector &d);

    static constexpr unsigned int damped_iterations = 200; ///< instead of the maximal number of iterations
    static constexpr double on_its_way = .5; ///< relative residual below which damped steps may go on,
    static constexpr unsigned int most_extensions = 4; ///< up to so many times that number
    static constexpr unsigned int slack_iterations = 4; ///< before slack is allowed; three times as many: more

    static constexpr double creeping = 1e-2; ///< share of a step below which it is a creeping one
    static constexpr double far_from_equilibrium = 1e-2; ///< relative residual above which such steps are counted
    static constexpr unsigned int most_creeping_steps = 3; ///< then an undamped attempt is given up

    NonlinearProblem &problem_;
    System &system_;
    const NewtonSettings &settings_;
    const std::vector<double> &scale_, &size_;
    double smallest_motion_; ///< displacements below are not a scale to measure steps by
    mutable double last_magnitude_ = 0; ///< the scale of the last measured residual
    double damping_ = 0; ///< of the next iteration, force over length
    Timers &timers_;
    Timers::Index timer_solve_;
  };
} // namespace deltaform
