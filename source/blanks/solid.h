#pragma once

#include "material_points.h"
#include "solid_discretization.h"
#include "solid_fields.h"
#include "solid_heat.h"
#include "solid_kernel.h"
#include "solid_motion.h"
#include "solid_refinement.h"
#include "solid_surface.h"
#include "solid_transfer.h"

#include <deltaform/blanks/blank.h>

#include <optional>
#include <vector>

namespace deltaform
{
  /**
   * Axisymmetric or plane strain solid of quadrilaterals of degree 1 or 2, unknowns u_r and u_z. The volumetric strain
   * is projected (degree 1: its mean over the cell; degree 2: linear in the cell), which makes it free of volumetric
   * locking and derives from a potential. Finite strain: multiplicative plasticity in the logarithmic strain; or small
   * strain. Derivation: doc/theory/solid.md.
   */
  class Solid : public Blank
  {
  public:
    explicit Solid(Section &section);

    const ContactSurface &surface() const override;
    const Boundary &boundary() const override;
    const Fields &fields() const override;
    Conducting *conducting() override;
    Adaptive *adaptive() override;
    const Adaptive *adaptive() const override;
    unsigned int n_dofs() const override;
    dealii::IndexSet locally_owned_dofs() const override;
    bool may_be_distributed() const override
    {
      // Points inside the edges want all of it in one process.
      return surface_.at_nodes();
    }
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
    bool constant_stiffness() const override;
    void touch_inside(DeltaSize delta, bool slides) override;
    void follow_flow_stress(Side side) override;
    bool shared_at_nodes() const override
    {
      return shared_at_nodes_;
    }
    Status assemble(const Vector &q, AssemblyTarget &target) override;
    double admissible_step(const Vector &q, const Vector &dq) const override;
    void begin_increment(double duration, double ratio) override;
    double flow_error() const override;
    IncrementSize increment_size(const Vector &dq) const override;
    void commit(const Vector &q) override;
    BlankEnergy energy() const override;
    void count_no_energy() override;
    KeyedArrays state() const override;
    void set_state(const KeyedArrays &state) override;
    KeyedArrays formed(const Vector &q) override;
    TakenOver take_formed(const KeyedArrays &formed) override;

  private:
    /// Is the mesh as read that of a formed solid, and does what has happened to that one since happen to this one?
    bool goes_on_like(const KeyedArrays &formed) const;

    /// Stress at the begin of the increment, turned with the material.
    Mandel start_stress(std::size_t point, const Turn &turn) const;

    // As read
    unsigned int degree_;
    bool axisymmetric_;
    SolidMotion motion_;
    RefinementSettings refinement_settings_;
    bool shared_at_nodes_ = false;

    // Its parts, in the order in which the scene is read
    SolidDiscretization body_;
    SolidSurface surface_;
    MaterialPoints material_; ///< cell by cell
    SolidKernel kernel_;
    SolidTransfer transfer_;
    SolidRefinement refinement_;
    std::vector<Mandel> flow_; ///< plastic strain of the last increment, of every own point
    SolidFields fields_;
    std::optional<SolidHeat> heat_; ///< of a metal that conducts
    double outermost_ = 0; ///< radius
  };
} // namespace deltaform
