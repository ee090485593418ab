#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/contact_surface.h>
#include <deltaform/assembly/delta_size.h>
#include <deltaform/assembly/energy.h>
#include <deltaform/assembly/status.h>
#include <deltaform/assembly/types.h>
#include <deltaform/blanks/adaptive.h>
#include <deltaform/blanks/boundary.h>
#include <deltaform/blanks/conducting.h>
#include <deltaform/blanks/element_chain.h>
#include <deltaform/blanks/fields.h>
#include <deltaform/blanks/increment_size.h>
#include <deltaform/blanks/sheet_section.h>
#include <deltaform/io/keyed_arrays.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /// What a run takes over from an earlier operation.
  struct TakenOver
  {
    Vector unknowns;

    /// On another mesh: forces on the unknowns that held the blank in its shape (force, moment). What else misses
    /// equilibrium there is the error of the transfer. Empty: the two are not told apart.
    std::optional<Vector> held;
  };


  /**
   * The body that is formed: its unknowns, its internal forces and their tangent, and its state from increment to
   * increment. It owns its material and the history of its points. Contact, loads, refinement and results see parts of
   * it through interfaces of their own.
   */
  class Blank
  {
  public:
    virtual ~Blank() = default;

    /// @name Parts
    ///@{
    /// For contact.
    virtual const ContactSurface &surface() const = 0;

    /// For supports and loads.
    virtual const Boundary &boundary() const = 0;

    /// For results.
    virtual const Fields &fields() const = 0;

    /// For the flow of heat; null if heat stays where it is made, or is not counted.
    virtual Conducting *conducting()
    {
      return nullptr;
    }

    /// For refinement; null if the blank keeps its mesh.
    virtual Adaptive *adaptive()
    {
      return nullptr;
    }
    virtual const Adaptive *adaptive() const
    {
      return nullptr;
    }
    ///@}

    /// @name Unknowns
    ///@{
    virtual unsigned int n_dofs() const = 0;

    /// The unknowns whose rows of the matrix this process keeps; all of them if the blank is not distributed.
    virtual dealii::IndexSet locally_owned_dofs() const
    {
      return dealii::complete_index_set(n_dofs());
    }

    /// May its cells be shared among processes? Then what needs all of the matrix in one is left alone, so that the
    /// iterations are the same on any number of them.
    virtual bool may_be_distributed() const
    {
      return false;
    }

    /// Of a sheet whose elements pass a tool one after the other; else empty.
    virtual const ElementChain &chain() const
    {
      return ElementChain::none();
    }

    /// Enter the couplings between unknowns that the cells of this process make.
    virtual void add_couplings(dealii::DynamicSparsityPattern &pattern) const = 0;

    /// Unknowns that stay zero: symmetry at the axis r = 0, rotations of a membrane.
    virtual std::vector<DofIndex> fixed_dofs() const = 0;

    /// A typical length that makes unknowns comparable: 1 for displacements, the thickness for rotations.
    virtual double dof_scale(DofIndex dof) const = 0;

    /// "node 12 at r = 0.53, rotation", for messages.
    virtual std::string describe_dof(DofIndex dof) const = 0;

    /// Positions of the nodes: r and z.
    virtual std::vector<Point2> positions(const Vector &q) const = 0;

    /// Velocities of the unknowns in a rigid motion: translation, and angular velocity about the origin.
    virtual void rigid_motion(const Vector &q,
                              const Tensor1 &translation,
                              double rotation,
                              const std::function<void(DofIndex, double)> &set) const = 0;
    ///@}

    /// @name Scales and kind
    ///@{
    virtual bool axisymmetric() const = 0;

    virtual double initial_thickness() const = 0;

    /// The length that penetrations and steps are compared with: the thickness of a shell, the shortest contact edge of
    /// a solid.
    virtual double typical_length() const = 0;

    /// A typical stiffness, force over length: Young's modulus times the thickness.
    virtual double stiffness_scale() const = 0;

    /// Flow stress of the undeformed material (stress); infinite if it is elastic.
    virtual double initial_flow_stress() const = 0;

    /// Does it go on changing while nothing moves, by flow that depends on the rate or by heat?
    virtual bool depends_on_time() const
    {
      return false;
    }

    /// Is the tangent the same in every state? assemble() then needs to give it once.
    virtual bool constant_stiffness() const
    {
      return false;
    }
    ///@}

    /// The penalty factor of every contact point is found, so that each keeps delta, however many there are: where the
    /// scene leaves it open, contact points lie inside the elements if that suits such a delta. To be said before
    /// anything touches the surface.
    /// @param slides nothing presses the sheet on a tool by a force, or between two tools, and one end of it is free
    virtual void touch_inside(DeltaSize /*delta*/, bool /*slides*/)
    {
    }

    /// Friction depends on the flow stress of this face: from here on it is followed. To be said by all processes
    /// together, once contact points are where they stay.
    virtual void follow_flow_stress(Side /*side*/)
    {
    }

    /// Has touch_inside() been refused only because several processes share the blank?
    virtual bool shared_at_nodes() const
    {
      return false;
    }

    /// @name In every iteration
    ///@{
    /// Add internal forces and, if wanted, their tangent at @p q. The trial history starts from the committed one.
    virtual Status assemble(const Vector &q, AssemblyTarget &target) = 0;

    /// Largest factor in (0, 1] by which @p dq may be taken so that no cell is turned inside out or rotated too far.
    virtual double admissible_step(const Vector &q, const Vector &dq) const = 0;
    ///@}

    /// @name Once per increment
    ///@{
    /**
     * The increment to come.
     * @param duration time that it takes (time), for materials that want to know; 0, where equilibrium is sought anew
     *   at the same time: a moment, too short for a rate-dependent flow stress to relax
     * @param ratio of its length to that of the last accepted one; 0: there is none that it continues
     */
    virtual void begin_increment(double duration, double ratio) = 0;

    /// Estimated relative error of this increment's plastic strain (committed to trial) by backward Euler, mean over
    /// the blank.
    virtual double flow_error() const
    {
      return 0.;
    }

    /// How far the trial state, which the displacement increment @p dq led to, is from the committed one.
    virtual IncrementSize increment_size(const Vector &dq) const = 0;

    /// Cross-sections of a sheet at its nodes in the trial state, without what presses on them; none of a solid.
    virtual std::vector<SheetSection> trial_sections() const
    {
      return {};
    }

    /// Accept the trial state that belongs to @p q: history, thickness, energies.
    virtual void commit(const Vector &q) = 0;

    /// Does it want to know what presses on its faces?
    virtual bool feels_pressure() const
    {
      return false;
    }

    /// Pressure at the nodes of both faces in the increment that is solved: the transverse stress of a shell.
    virtual void set_pressure(const FaceValues & /*pressure*/)
    {
    }

    /// By how much that pressure would change the transverse stress: the most at any node, over the initial flow
    /// stress.
    virtual double pressure_change(const FaceValues & /*pressure*/) const
    {
      return 0.;
    }

    virtual BlankEnergy energy() const = 0;

    /// Switch energies off: they are zero from here on, and cost nothing.
    virtual void count_no_energy() = 0;
    ///@}

    /// @name State: what the next increment finds, of the cells of this process
    ///@{
    virtual KeyedArrays state() const = 0;

    /// Go to a state, forwards or back. The mesh is refined as it was there: the number of unknowns may change.
    /// @throws SceneError if it is the state of another blank, or of one that was refined less
    virtual void set_state(const KeyedArrays &state) = 0;
    ///@}

    /// @name From one operation to the next
    ///@{
    /// What the blank has been formed to at its accepted unknowns @p q: its state, and where it is known. Leaves the
    /// trial state at @p q.
    virtual KeyedArrays formed(const Vector &q);

    /// Begin with what another blank of the same kind has been formed to. The number of unknowns may change: a mesh
    /// that was refined comes over as it was.
    /// @throws SceneError if this blank is no part of that one, or cannot have another mesh
    virtual TakenOver take_formed(const KeyedArrays &formed);
    ///@}

  protected:
    /// Do a formed blank, before any refinement, and this one have the same nodes?
    bool has_nodes_of(const KeyedArrays &formed) const;
  };
} // namespace deltaform
