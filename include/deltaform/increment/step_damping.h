#pragma once

#include <limits>

namespace deltaform
{
  /**
   * A radius that keeps Newton's method close to equilibrium from steps along what nothing resists.
   *
   * There a full step should all but end the iteration. Where less than half is taken of two in a row the tangent is
   * nearly singular: sections of a perfectly plastic sheet that all carry their full moment share a bend as they like,
   * until one unloads. So it is where a step that is long against what was foreseen of the increment makes the residual
   * larger. From then on a step is no longer than what was taken of those (RadiusSearch: a stiffness in the metric in
   * which steps are measured); what the blank resists keeps its step. The radius grows with every step that needs all
   * of it and of which more is taken, so that the end of a solve stays quadratic. A damped step is no measure of the
   * error: Newton's method ends with one that is not. Derivation: doc/theory/solver.md.
   */
  class StepDamping
  {
  public:
    /// @param residual  relative
    /// @return of the next step, scaled; infinite far from equilibrium, and as long as there is no reason for one
    double radius(double residual) const;

    /**
     * A step without damping has led to a larger residual: was it too long? Then the radius is for that in its place.
     * @param residual  relative, where it begins
     * @param length    of it, scaled
     * @param way       of the increment to where the solve started, scaled
     */
    bool bound(double residual, double length, double way);

    /**
     * The radius of a step in place of one whose sets lead to each other: a quarter of the one before, and no more than
     * @p most.
     * @param residual  relative, where it begins
     * @return false far from equilibrium, where there is none
     */
    bool shorten(double residual, double most);

    /**
     * A step was made.
     * @param residual  relative, where it began
     * @param factor    of the step that was taken
     * @param length    of the whole step, scaled
     */
    void judge(double residual, double factor, double length);

    /// Forces are balanced, but the last step was damped: the next may be longer.
    void loosen();

  private:
    unsigned int n_cut_ = 0; ///< steps in a row of which little was taken
    double radius_ = std::numeric_limits<double>::infinity();
  };
} // namespace deltaform
