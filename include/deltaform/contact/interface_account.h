#pragma once

#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/interface_friction.h>
#include <deltaform/contact/interface_state.h>

#include <utility>
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

    /// A point that touches or did when the increment began, and what it has done since.
    struct Increment
    {
      const ContactProjector &projector;
      const InterfaceFriction *friction; ///< null: none
      unsigned int point;
      const ContactPointState &before;
      ContactPointState &now;
      const Tensor1 &shift; ///< way of the counterpart at the end
      double offset; ///< of its face in this increment
      double slip; ///< of it, a length along the tool; 0 without friction
    };

    /// Work of friction, of changing factors, along the face, and on points that were put elsewhere between the
    /// increments, at the accepted @p q.
    void add(const Increment &increment, const Vector &q, ContactEnergy &energy);

    void finish(const ContactProjector &projector, InterfaceState &accepted);
    ///@}

    /// The points are others, under the same forces: what that adds to the stored energy counts as work of changing
    /// factors.
    void renew(const ContactProjector &projector, InterfaceState &state) const;

    /// The springs leave with the tool, and what they hold.
    static void release(ContactEnergy &energy);

  private:
    void add_friction(const Increment &increment, ContactEnergy &energy);

    /// What the springs gain beyond the work of their forces. @param start the point where the increment has begun
    /// @param closest its closest point on the counterpart there @param end the same at the end
    /// @param ways of the places that bear the forces at the start and at the end, along the normals there
    void add_springs(const Increment &increment, const ContactPoint &start, const Projection &closest,
                     const Projection &end, const std::pair<double, double> &ways, ContactEnergy &energy) const;

    /// The slope at the end of the increment is set. @param end closest point there
    /// @param ways of the places that bear the forces at the start and at the end, along the tool there
    static void add_climbing(const Increment &increment, const Vector &q, const Projection &end,
                             const std::pair<double, double> &ways, ContactEnergy &energy);

    static void add_update(const Increment &increment, const ContactPoint &start, const Projection &closest,
                           ContactEnergy &energy);

    /// In the springs of all points: penalty springs, thickness, tangential springs.
    double stored(const ContactProjector &projector, const std::vector<ContactPointState> &points) const;

    bool normal_springs_, counts_ = true;
    std::vector<double> friction_work_;
    double growth_ = 0; ///< of the work of friction over the slip, from the forces at the start to those at the end
  };
} // namespace deltaform
