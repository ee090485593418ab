#pragma once
// The energies of an interface from its accepted states alone.
#include <deltaform/assembly/energy.h>
#include <deltaform/contact/contact_point_state.h>

#include <vector>

namespace deltaform
{
  /// In the springs of all points: penalty springs (@p normal_springs: they keep their penetration), thickness,
  /// tangential springs.
  inline double stored_energy(const std::vector<ContactPointState> &points, const bool normal_springs)
  {
    double sum = 0.;
    for (const auto &state : points)
      if (state.touching)
      {
        const double p = state.penetration();
        if (normal_springs)
          sum += .5 * state.penalty_factor * p * p;
        sum += .5 * state.compliance * state.force * state.force;
        if (state.tangential_factor > 0)
          sum += .5 * state.tangential_force * state.tangential_force / state.tangential_factor;
      }
    return sum;
  }

  /// Work of friction and of changing factors in an increment, point by point.
  class IncrementWork
  {
  public:
    IncrementWork(ContactEnergy &energy, const bool normal_springs)
      : energy_(energy), normal_springs_(normal_springs)
    {
    }

    /// @param slip of the increment, a length along the tool; 0 without friction. @return work of friction
    double add(const ContactPointState &before, const ContactPointState &now, const double slip)
    {
      // What the springs gain beyond the trapezoidal work of their forces (eps p at both ends) when eps changes on the
      // way. The round in which it changed does not matter, and a first touch (p = 0) counts nothing: its force goes
      // from zero to the accepted one, whatever the factors of the rounds in between.
      if (normal_springs_ && before.touching && now.touching)
        energy_.epsilon +=
          .5 * (now.penalty_factor - before.penalty_factor) * before.penetration() * now.penetration();
      const double first = before.touching ? before.tangential_force : 0.,
                   last = now.touching ? now.tangential_force : 0.;
      const double friction = .5 * (first + last) * slip - (stored(now, last) - stored(before, first));
      energy_.friction += friction;
      growth_ += (last - first) * slip;
      return friction;
    }

    /**
     * A point has touched or let go on the way. The trapezoidal rule lets half of its force work over the open gap,
     * where it had none.
     * @param force where it touched @param gap where it did not (length)
     */
    void add_event(const bool touched, const double force, const double gap)
    {
      energy_.epsilon += (touched ? -.5 : .5) * force * gap;
    }

    void finish()
    {
      // The force has changed by the growth somewhere within the increment; the trapezoidal rule has put it in the
      // middle. Where it was is as good as random: the error is evenly spread between half the growth and its negative.
      energy_.friction_variance += growth_ * growth_ / 12.;
    }

  private:
    /// In the tangential spring of a point with the force @p t.
    static double stored(const ContactPointState &state, const double t)
    {
      return state.touching && state.tangential_factor > 0 ? .5 * t * t / state.tangential_factor : 0.;
    }

    ContactEnergy &energy_;
    bool normal_springs_;
    double growth_ = 0; ///< of the work of friction over this slip, from the forces at the start to those at the end
  };
} // namespace deltaform
