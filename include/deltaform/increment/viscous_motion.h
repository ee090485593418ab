#pragma once

#include <deltaform/increment/increment_problem.h>
#include <deltaform/increment/newton.h>
#include <deltaform/increment/viscous_equations.h>

#include <limits>

namespace deltaform
{
  /**
   * The way of a blank from where it is to an equilibrium, as in a viscous medium: in steps, each of which is an
   * equilibrium with the forces of the medium. The viscosity falls as long as steps are solved, and grows where one is
   * not, from the state before it. Derivation: doc/theory/solver.md, Where the path ends.
   */
  class ViscousMotion
  {
  public:
    /// @param newton          for the equations of the problem without the medium
    /// @param q               in: where the blank is; out: the equilibrium, if there is one
    /// @param most_iterations of all steps; some more where it is nearly at rest
    ViscousMotion(IncrementProblem &problem, Newton &newton, Vector &q, unsigned int most_iterations);

    /// To rest. Diverged: the iterations or the viscosity have come to their end; singular: nothing holds the blank.
    NewtonResult run();

  private:
    /// From where the blank is to trial_. @return is it a solution? Of a rough step: but for the promise
    bool solve(Newton &newton);

    /// A step could not be solved: back, and a more viscous medium.
    void resist();

    /// To the end of the step, and with what viscosity?
    void go_on();

    /// Is there an equilibrium without the medium close by? Asked for now and then, where the blank is nearly at rest.
    bool finds_equilibrium();

    /// Does the way to trial_ begin downhill? With too little viscosity (K + c M indefinite) steps lead up, to
    /// equilibria that are not stable. Close to rest nothing is said of it.
    bool descends() const;

    /// Has it moved by more than its size?
    bool is_free() const;

    /// Are there iterations left?
    bool may_go_on();

    /// Do steps have to be exact?
    bool is_nearly_at_rest() const;

    /// Over all forces, after a step: the norm of those of the medium.
    double forces_of_medium() const;

    /// Geometric mean of the diagonal of the tangent, in units of M.
    double mean_stiffness() const;

    /// R(q) of what was assembled last, without the medium.
    void remember_residual();

    NewtonResult ended(NewtonResult::Outcome outcome);

    IncrementProblem &problem_;
    Newton &newton_;
    Vector &q_;
    Vector trial_;
    Vector residual_; ///< R where the blank is, of unknowns that are not prescribed
    unsigned int most_iterations_;
    unsigned int last_way_ = 200; ///< further ones, if the blank is nearly at rest when these are used up

    ViscousEquations viscous_;
    const NewtonSettings rough_;
    Newton roughly_, exactly_; ///< for the steps: far from rest, and close to it
    NewtonResult last_;

    double viscosity_; ///< over the mean stiffness
    double forces_ = std::numeric_limits<double>::infinity(); ///< of the medium, over all, in the last step
    unsigned int n_iterations_ = 0, n_steps_ = 0, n_unbalanced_ = 0;
    unsigned int next_trial_; ///< of an equilibrium without the medium: after so many steps
    unsigned int pause_ = 0; ///< steps until the viscosity may fall again
  };
} // namespace deltaform
