#pragma once

#include <limits>

namespace deltaform
{
  /**
   * A stiffness that keeps Newton's method close to equilibrium from steps along what nothing resists (regularized
   * Newton; Li, Fukushima, Qi and Yamashita 2004, Comput. Optim. Appl. 28, 131).
   *
   * There a full step should all but end the iteration. Where less than half is taken of two in a row the tangent is
   * nearly singular: sections of a perfectly plastic sheet that all carry their full moment share a bend as they like,
   * until one unloads. So it is where a step that is long against what was foreseen of the increment makes the residual
   * larger. Then |R| / radius is added to the tangent, in the metric in which steps are measured, so that such a step
   * comes to the radius at most; what the blank resists keeps its step. The damping fades with |R|, so that the end
   * stays quadratic, and with every step of which more is taken. A damped step is no measure of the error: Newton's
   * method ends with one that is not. Derivation: doc/theory/solver.md.
   */
  class StepDamping
  {
  public:
    /// @param residual   relative
    /// @param magnitude  what it is relative to [force]
    /// @return what to add to the tangent [force/length]
    double stiffness(double residual, double magnitude) const;

    /**
     * A step without damping has led to a larger residual: was it too long? Then stiffness() damps that in its place.
     * @param residual  relative, where it begins
     * @param length    of it, scaled
     * @param way       of the increment to where the solve started, scaled
     */
    bool bound(double residual, double length, double way);

    /**
     * A step was made.
     * @param residual  relative, where it began
     * @param next      where it ended
     * @param factor    of the step that was taken
     * @param length    of the whole step, scaled
     */
    void judge(double residual, double next, double factor, double length);

  private:
    unsigned int n_cut_ = 0; ///< steps in a row of which little was taken
    double radius_ = std::numeric_limits<double>::infinity(); ///< for steps that nothing resists
  };
} // namespace deltaform
