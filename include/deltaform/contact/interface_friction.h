#pragma once

#include <deltaform/assembly/contact_surface.h>
#include <deltaform/contact/contact_point_state.h>
#include <deltaform/contact/friction_law.h>

#include <memory>
#include <utility>
#include <vector>

namespace deltaform
{
  /// The law of friction of an interface, and what it has to know of the blank.
  class InterfaceFriction
  {
  public:
    explicit InterfaceFriction(std::unique_ptr<FrictionLaw> law)
      : law_(std::move(law))
    {
    }

    const FrictionLaw &law() const
    {
      return *law_;
    }

    void begin_increment(const ContactSurface &surface, Side side);

    /// Largest |t| of point @p i at the normal force @p normal_force.
    double limit(unsigned int i,
                 const ContactPointState &before,
                 const ContactPointState &now,
                 const double normal_force) const
    {
      return law_->limit(input(i, before, now, normal_force)).value;
    }

    /// Force of point @p i after a slip since the accepted state @p before, at the normal force @p normal_force.
    FrictionResponse respond(unsigned int i,
                             const ContactPointState &before,
                             const ContactPointState &now,
                             double slip_increment,
                             double normal_force) const;

  private:
    FrictionInput input(unsigned int i,
                        const ContactPointState &before,
                        const ContactPointState &now,
                        double normal_force) const;

    std::unique_ptr<FrictionLaw> law_;
    std::vector<double> flow_stress_; ///< accepted, of the blank's surface; empty if the law does not ask
  };
} // namespace deltaform
