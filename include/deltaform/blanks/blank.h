#pragma once

#include <deltaform/base/assembly_target.h>
#include <deltaform/base/drawing.h>
#include <deltaform/base/energy.h>
#include <deltaform/base/keyed_arrays.h>
#include <deltaform/base/status.h>
#include <deltaform/base/table.h>
#include <deltaform/base/types.h>
#include <deltaform/blanks/increment_size.h>
#include <deltaform/blanks/sheet_section.h>
#include <deltaform/kinematics/contact_surface.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace deltaform
{
  struct RefinementSettings;

  /// A part of the boundary on which displacements and loads can be prescribed, by direction.
  enum class Component : unsigned char
  {
    r,
    z,
    rotation
  };

  /**
   * The body that is formed: sets up its unknowns, assembles its internal forces and their tangent, hands out contact
   * nodes, commits an accepted increment and describes its fields. It owns its material and the history of its points.
   */
  class Blank : public ContactSurface
  {
  public:
    /// @name Set up
    ///@{
    virtual unsigned int n_dofs() const = 0;

    /// The unknowns whose rows of the matrix this process keeps; all of them if the blank is not distributed.
    virtual dealii::IndexSet locally_owned_dofs() const
    {
      return dealii::complete_index_set(n_dofs());
    }

    unsigned int n_contact_dofs() const override
    {
      return n_dofs();
    }

    /// Enter the couplings between unknowns that the cells of this process make.
    virtual void add_couplings(dealii::DynamicSparsityPattern &pattern) const = 0;

    /// Unknowns that stay zero: symmetry at the axis r = 0, rotations of a membrane.
    virtual std::vector<DofIndex> fixed_dofs() const = 0;

    /// Unknowns of one component on a named part of the boundary; empty if the blank has no such component (the
    /// rotation of a solid). @throws std::invalid_argument if there is no such part.
    virtual std::vector<DofIndex> boundary_dofs(const std::string &boundary, Component component) const = 0;

    /// Names of the parts of the boundary.
    virtual std::vector<std::string> boundaries() const = 0;

    /// Where the unknowns of boundary_dofs() are in the undeformed blank, one point per unknown.
    virtual std::vector<Point2> boundary_points(const std::string &boundary) const = 0;

    /// What a unit load on a part of the boundary is to the unknowns of boundary_dofs(): initial circumference of an
    /// edge (shell; line loads), consistent share of the initial area (solid; tractions).
    virtual std::vector<double> boundary_weights(const std::string &boundary) const = 0;

    /// Parts on which a pressure may act, the usual one first.
    virtual std::vector<std::string> faces() const = 0;

    /// The nodes of one of faces(), by their places in positions().
    virtual std::vector<unsigned int> face_nodes(const std::string &face) const = 0;

    /// Unknowns of a displacement component with their consistent shares of the initial volume, for body loads.
    virtual std::vector<std::pair<DofIndex, double>> volume_weights(Component component) const = 0;

    /// A typical length that makes unknowns comparable: 1 for displacements, the thickness for rotations.
    virtual double dof_scale(DofIndex dof) const = 0;

    /// "node 12 at r = 0.53, rotation", for messages.
    virtual std::string describe_dof(DofIndex dof) const = 0;

    /// A typical stiffness, force over length: Young's modulus times the thickness.
    virtual double stiffness_scale() const = 0;

    double modulus() const override
    {
      return stiffness_scale() / initial_thickness();
    }

    /// Flow stress of the undeformed material (stress); infinite if it is elastic.
    virtual double initial_flow_stress() const = 0;

    /// Is the tangent the same in every state? assemble() then needs to give it once.
    virtual bool constant_stiffness() const
    {
      return false;
    }

    virtual bool axisymmetric() const = 0;

    virtual double initial_thickness() const = 0;

    /// The length that penetrations and steps are compared with: the thickness of a shell, the shortest contact edge of
    /// a solid.
    virtual double typical_length() const = 0;
    ///@}

    /// @name In every iteration
    ///@{
    /// Add internal forces and, if wanted, their tangent at @p q. The trial history starts from the committed one.
    virtual Status assemble(const Vector &q, AssemblyTarget &target) = 0;

    /// Add the forces of a pressure on one of faces(), positive if it pushes into the blank (on the bottom: along the
    /// director, upward for a flat blank). Following: on the current area along the current normal; dead: on the
    /// initial area and normal.
    virtual void assemble_pressure(const Vector &q,
                                   const std::string &face,
                                   double pressure,
                                   bool following,
                                   AssemblyTarget &target) const = 0;

    /// Largest factor in (0, 1] by which @p dq may be taken so that no cell is turned inside out or rotated too far.
    virtual double admissible_step(const Vector &q, const Vector &dq) const = 0;
    ///@}

    /// @name Once per increment
    ///@{
    /**
     * The increment to come.
     * @param duration time that it takes (time), for materials that want to know; 0, where equilibrium is sought anew
     *   at the same time: as long as the last one
     * @param ratio of its length to that of the last accepted one; 0: there is none that it continues
     */
    virtual void begin_increment(double duration, double ratio) = 0;

    /// Estimated share of the plastic strain of this increment (committed to trial) that the integration of flow in one
    /// step leads astray, mean over the blank.
    virtual double flow_error() const
    {
      return 0.;
    }

    /// How far the trial state, which the displacement increment @p dq led to, is from the committed one.
    virtual IncrementSize increment_size(const Vector &dq) const = 0;

    /// Accept the trial state that belongs to @p q: history, thickness, energies.
    virtual void commit(const Vector &q) = 0;

    /// Contact pressure on the nodes of one side of the accepted state; used by the next increments (transverse
    /// stress).
    virtual void set_contact_pressure(Side side, const std::vector<double> &pressure) = 0;

    virtual BlankEnergy energy() const = 0;

    /// Nobody asks for energies: they are zero from here on, and cost nothing.
    virtual void forget_energy() = 0;

    virtual double smallest_thickness() const = 0;
    ///@}

    /// @name Refinement between increments; a blank that offers none keeps its mesh
    ///@{
    /// When to refine; null: never.
    virtual const RefinementSettings *refinement() const
    {
      return nullptr;
    }

    /// Mark what is to be refined in the accepted state: by the settings, and every contact edge of a side that is
    /// longer than @p longest_edges (undeformed). @return is anything marked?
    virtual bool mark(const std::array<std::vector<double>, 2> & /*longest_edges*/)
    {
      return false;
    }

    /// Refine what is marked. @p fields are values of the unknowns: in, on the old mesh; out, on the new one (the first
    /// is the accepted state).
    virtual void refine(std::vector<Vector> & /*fields*/)
    {
    }

    /// Relative error in energy as estimated by the last mark(); NaN if it was not.
    virtual double estimated_error() const
    {
      return std::numeric_limits<double>::quiet_NaN();
    }

    virtual unsigned int n_cells() const = 0;

    /// Of every contact node after refine(): the two old ones between which it lies in the middle; twice the same: that
    /// node itself.
    virtual const std::vector<std::array<unsigned int, 2>> &heritage(Side side) const
    {
      static const std::array<std::vector<std::array<unsigned int, 2>>, 2> none;
      return none[static_cast<unsigned int>(side)];
    }
    ///@}

    /// @name Results of the accepted state
    ///@{
    /// Values along the blank, one row per node.
    virtual Table profile(const Vector &q) const = 0;

    /// Is it a sheet, with cross-sections?
    virtual bool is_sheet() const
    {
      return false;
    }

    /// Cross-sections at the nodes; empty if the blank is no sheet (a solid carries its necks itself).
    virtual std::vector<SheetSection> sections() const
    {
      return {};
    }

    /// Picture for ParaView; @p nodal are further values, one per entry of positions() (shell: spread over the
    /// thickness).
    virtual Drawing draw(const Vector &q, const std::vector<DrawnField> &nodal) const = 0;

    /// Positions of the nodes: r and z.
    virtual std::vector<Point2> positions(const Vector &q) const = 0;

    /// Velocities of the unknowns in a rigid motion: translation, and angular velocity about the origin.
    virtual void rigid_motion(const Vector &q,
                              const Tensor1 &translation,
                              double rotation,
                              const std::function<void(DofIndex, double)> &set) const = 0;
    ///@}

    /// @name State: what the next increment finds, of the cells of this process
    ///@{
    virtual KeyedArrays state() const = 0;

    /// Go to a state, forwards or back. The mesh is refined as it was there: the number of unknowns may change.
    /// @throws SceneError if it is the state of another blank, or of one that was refined less
    virtual void set_state(const KeyedArrays &state) = 0;
    ///@}
  };
} // namespace deltaform
