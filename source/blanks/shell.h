#pragma once

#include "elastic_core.h"
#include "material_points.h"
#include "shell_boundary.h"
#include "shell_fields.h"
#include "shell_kernel.h"
#include "shell_parts.h"
#include "shell_points.h"
#include "shell_refinement.h"
#include "shell_space.h"
#include "shell_state.h"
#include "shell_surface.h"

#include <deltaform/blanks/blank.h>

#include <vector>

namespace deltaform
{
  /**
   * Shell of revolution, or strip in plane strain, on a Triangulation<1,2>: unknowns u_r, u_z and the rotation at each
   * node, finite rotations and membrane strains, layers through the thickness in plane stress. Reduced integration
   * along the meridian (degree points) makes it free of locking. Derivation: doc/theory/shell.md.
   */
  class Shell : public Blank
  {
  public:
    explicit Shell(Section &section);

    const ContactSurface &surface() const override;
    const Boundary &boundary() const override;
    const Fields &fields() const override;
    Adaptive *adaptive() override;
    const Adaptive *adaptive() const override;
    unsigned int n_dofs() const override;
    const ElementChain &chain() const override;
    void add_couplings(dealii::DynamicSparsityPattern &pattern) const override;
    std::vector<DofIndex> fixed_dofs() const override;
    double dof_scale(DofIndex dof) const override;
    std::string describe_dof(DofIndex dof) const override;
    std::vector<Point2> positions(const Vector &q) const override;
    void rigid_motion(const Vector &q,
                      const Tensor1 &translation,
                      double rotation,
                      const std::function<void(DofIndex, double)> &set) const override;
    bool axisymmetric() const override;
    double initial_thickness() const override;
    double typical_length() const override;
    double stiffness_scale() const override;
    double initial_flow_stress() const override;
    bool depends_on_time() const override;
    Status assemble(const Vector &q, AssemblyTarget &target) override;
    double admissible_step(const Vector &q, const Vector &dq) const override;
    void touch_inside(DeltaSize delta, bool slides) override;
    void follow_flow_stress(Side side) override;
    void begin_increment(double duration, double ratio) override;
    double flow_error() const override;
    IncrementSize increment_size(const Vector &dq) const override;
    std::vector<SheetSection> trial_sections() const override;
    void commit(const Vector &q) override;
    bool feels_pressure() const override;
    void set_pressure(const FaceValues &pressure) override;
    double pressure_change(const FaceValues &pressure) const override;
    BlankEnergy energy() const override;
    void count_no_energy() override;
    KeyedArrays state() const override;
    void set_state(const KeyedArrays &state) override;
    KeyedArrays formed(const Vector &q) override;
    TakenOver take_formed(const KeyedArrays &formed) override;

  private:
    /// Thickness of a quadrature point in the trial state (length).
    double trial_thickness(unsigned int place) const;

    /// Count the energies of the layers of a quadrature point and of its transverse shear.
    void add_energy(const ShellStrain &strain, unsigned int place, BlankEnergy &sum) const;

    /// Work of what corrects the layers at the ends of the elastic core, at a quadrature point.
    double core_work(unsigned int place) const;

    /// Of the stresses at a quadrature point, on the ratio of its layers, on its area (force/length): what does not
    /// depend on the length of the element is carried over where a mesh is refined.
    double layer_force(const ShellStrain &strain, unsigned int place) const;

    // Its parts, in the order in which the scene is read
    ShellSettings settings_;
    ShellSpace space_;
    ShellPoints points_;
    ShellState state_;
    ShellSurface surface_;
    ShellBoundary boundary_;
    MaterialPoints material_; ///< layer by layer, of every quadrature point
    ElasticCore core_;
    ShellKernel kernel_;
    ShellFields fields_;
    ShellParts parts_;
    ShellRefinement refinement_;
  };
} // namespace deltaform
