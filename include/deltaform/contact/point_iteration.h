#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/factor_control.h>
#include <deltaform/contact/interface_friction.h>
#include <deltaform/contact/normal_law.h>
#include <deltaform/contact/pressure_rows.h>

#include <optional>
#include <utility>
#include <vector>

namespace deltaform
{
  /**
   * The points of an interface, one by one, in the iterations of an increment: force and status at the present
   * unknowns, what they add to residual and tangent, and what a Newton step makes of the estimates of lambda.
   */
  class PointIteration
  {
  public:
    using Points = std::vector<ContactPointState>;

    /// Of a touching point: the displacement unknowns of the node nearest to it, and the tool's normal there. In these
    /// frames the matrix is scaled for its condition number.
    struct Frame
    {
      DofIndex r, z;
      Tensor1 normal;
    };

    /// @param friction null: none
    PointIteration(const NormalLaw &law,
                   ContactProjector &projector,
                   const FactorControl &factors,
                   const InterfaceFriction *friction);

    void resize(const unsigned int n_points)
    {
      work_.assign(n_points, Work());
    }

    unsigned int size() const
    {
      return work_.size();
    }

    /// Number of the first unknown of the law, one per point.
    void set_first_multiplier(const DofIndex first)
    {
      first_multiplier_ = first;
    }

    DofIndex multiplier_dof(const unsigned int i) const
    {
      return first_multiplier_ + i;
    }

    /// The next assembly is anywhere, with trial states that it did not leave. @p at_start: where an increment begins
    void restart(bool at_start);

    /// Nothing is known of point @p i.
    void renew(const unsigned int i)
    {
      work_[i] = Work();
    }

    /// Where the next assembly is.
    ///@{
    void stay_in_place()
    {
      in_place_ = true;
    }

    bool in_place() const
    {
      return in_place_;
    }

    bool at_start() const
    {
      return at_start_;
    }

    void leave_start()
    {
      at_start_ = false;
    }

    void leave_place()
    {
      in_place_ = false;
    }
    ///@}

    /// An assembly begins: no point has changed its status.
    void begin_assembly()
    {
      status_changed_ = false;
    }

    bool status_changed() const
    {
      return status_changed_;
    }

    /// Sum of the forces on the counterpart since the last call.
    Tensor1 take_force()
    {
      return std::exchange(force_, Tensor1());
    }

    /// At @p q: with its row over the unknowns, or with the row if it has none.
    ///@{
    void describe(unsigned int i, const Vector &q);
    void find_row(unsigned int i, const Vector &q);
    ///@}

    /// Residual and tangent: find status and normal force, then add the forces. Friction of points that share an edge
    /// asks for the normal forces of all of them first.
    ///@{
    void press(unsigned int i, const Vector &q, const Tensor1 &shift, const Points &committed, Points &trial);
    void add(unsigned int i, const Vector &q, const Points &committed, Points &trial, AssemblyTarget &target);
    ///@}

    /// Points of an edge are added, which shares its friction.
    ///@{
    void begin_edge()
    {
      pressure_rows_.begin();
    }

    void end_edge(AssemblyTarget &target) const
    {
      if (target.wants_tangent())
        pressure_rows_.add_to(target);
    }
    ///@}

    /// Will it change its status in the step @p d from @p q?
    bool foresee(unsigned int i, const Vector &q, const Vector &d, const ContactPointState &state);

    /// Does foresee() let a touching point go?
    bool is_released(const unsigned int i, const ContactPointState &state) const
    {
      return state.touching && !work_[i].foreseen.value_or(true);
    }

    /// Let a point go that foresee() holds. @return was there any such?
    bool release(const unsigned int i)
    {
      Work &work = work_[i];
      if (!work.is_near || !work.foreseen.value_or(false))
        return false;
      work.foreseen = false;
      return true;
    }

    /// A step @p d is taken from @p state, by a factor. @p before: its accepted state
    ///@{
    void prepare_step(unsigned int i, const Vector &d, const ContactPointState &before, const ContactPointState &state);
    void advance(unsigned int i, double factor, ContactPointState &state);
    ///@}

    /// How far it may go from its place at the last assembly and stay without contact. Not positive: nobody knows.
    double clear_way(unsigned int i, const ContactPointState &state) const;

    /// As it was assembled last; one that was clear may be without its row.
    const ContactPoint &point(const unsigned int i) const
    {
      return work_[i].point;
    }

    std::vector<Frame> frames(const Points &trial) const;

  private:
    /// What is computed of a point in an iteration and discarded.
    struct Work
    {
      ContactPoint point; ///< at the last assembly
      bool has_row = false; ///< it was described, and not only located
      Projection projection; ///< the same, of a point that may have contact
      bool is_near = false; ///< it may have contact: it was projected
      NormalResponse normal; ///< of such a point, at the last assembly
      std::optional<bool> foreseen; ///< will it touch? See ContactInterface::foresee()
      double base_multiplier = 0, step_multiplier = 0; ///< estimates of lambda along a Newton step
    };

    /// Of a point relative to the counterpart in the step @p d.
    Tensor1 motion(unsigned int i, const Vector &d) const;

    /// Where it is at @p q, without its row.
    void locate(unsigned int i, const Vector &q);

    /// A point that has no contact, whatever its force was.
    void leave(unsigned int i, ContactPointState &state);

    /// A point that may have contact. @p known: its projection is
    void meet(unsigned int i, bool known, const Vector &q, const Points &committed, Points &trial);

    /// Add the forces of a point.
    void add(unsigned int i, const FrictionResponse &friction, const Vector &q, ContactPointState &state,
             AssemblyTarget &target);

    const NormalLaw &law_;
    ContactProjector &projector_;
    const FactorControl &factors_;
    const InterfaceFriction *friction_;
    DofIndex first_multiplier_ = dealii::numbers::invalid_dof_index;

    std::vector<Work> work_;
    bool status_changed_ = false;
    bool in_place_ = false; ///< no step has been made since the last assembly: points are described as it left them
    bool at_start_ = false; ///< no step has been made in this increment: points touch that did in the last one
    PressureRows pressure_rows_;
    Tensor1 force_;
  };
} // namespace deltaform
