#pragma once

#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/interface_state.h>

#include <vector>

namespace deltaform
{
  /// Adds up the energies of an interface from one accepted state to the next; the sums are in InterfaceState::energy.
  /// After stop() it counts nothing.
  class InterfaceAccount
  {
  public:
    /// @param normal_springs do penalty springs keep their penetration, and so their energy?
    explicit InterfaceAccount(const bool normal_springs)
      : normal_springs_(normal_springs)
    {
    }

    bool counts() const
    {
      return counts_;
    }

    void stop()
    {
      counts_ = false;
    }

    /// Dissipated by friction at every point in the last accepted increment (force*length); empty if nothing counts.
    const std::vector<double> &friction_work() const
    {
      return friction_work_;
    }

    /// @name The end of an increment
    ///@{
    void begin(unsigned int n_points);

    /// Work of friction and of changing factors at a point. @param slip of the increment, a length along the tool; 0
    /// without friction @param open_gap of a point that has touched or let go: where it was free
    void add(unsigned int point, const ContactPointState &before, const ContactPointState &now, double slip,
             double open_gap, ContactEnergy &energy);

    void finish(const ContactProjector &projector, InterfaceState &accepted);

    /// The thickness has become another than was foreseen, at fixed positions @p q and way of the counterpart: what the
    /// forces do on the faces that move. They stay those of the accepted equilibrium.
    void
    refresh(const ContactProjector &projector, const Vector &q, const Tensor1 &way, InterfaceState &accepted) const;
    ///@}

    /// The points are others, under the same forces: what that adds to the stored energy counts as work of changing
    /// factors.
    void renew(const ContactProjector &projector, InterfaceState &state) const;

    /// The springs leave with the tool, and what they hold.
    static void release(ContactEnergy &energy);

  private:
    /// In the springs of all points: penalty springs, thickness, tangential springs.
    double stored(const ContactProjector &projector, const std::vector<ContactPointState> &points) const;

    bool normal_springs_, counts_ = true;
    std::vector<double> friction_work_;
    double growth_ = 0; ///< of the work of friction over the slip, from the forces at the start to those at the end
  };
} // namespace deltaform
