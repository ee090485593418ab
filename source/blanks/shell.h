#pragma once

#include "material_points.h"
#include "shell_mesh.h"

#include <deltaform/blanks/blank.h>
#include <deltaform/kinematics/shell_strain.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>

#include <memory>

namespace deltaform
{
  /// Where the contact point of a node lies (doc/theory/contact.md).
  enum class ContactPoint : unsigned char
  {
    normal_offset, ///< the node, half a thickness away from the tool along the tool's normal
    outer_fibre ///< on the face of the blank, half a thickness along the director
  };

  /// What stays the same at a quadrature point on the meridian of a shell.
  struct ShellPoint
  {
    std::array<double, 3> shape{}, gradient{}; ///< N_a and dN_a/dS
    double radius = 1; ///< R (plane strain: 1)
    double angle = 0; ///< of the reference tangent
    double angle_prime = 0; ///< reference curvature
    double lambda = 1, gamma = 0; ///< reference values of Lambda and Gamma
    double weight = 0; ///< 2 pi dS (plane strain: dS)
  };

  /**
   * Shell of revolution, or strip in plane strain, on a Triangulation<1,2>: unknowns u_r, u_z and the rotation at each
   * node, finite rotations and membrane strains, layers through the thickness in plane stress. Reduced integration
   * along the meridian (degree points) makes it free of locking. Derivation: doc/theory/shell.md.
   */
  class Shell : public Blank
  {
  public:
    explicit Shell(Section &section);

    unsigned int n_dofs() const override;
    void add_couplings(dealii::DynamicSparsityPattern &pattern) const override;
    std::vector<DofIndex> fixed_dofs() const override;
    std::vector<DofIndex> boundary_dofs(const std::string &boundary, Component component) const override;
    std::vector<std::string> boundaries() const override;
    std::vector<Point2> boundary_points(const std::string &boundary) const override;
    std::vector<double> boundary_weights(const std::string &boundary) const override;
    std::vector<std::string> faces() const override;
    std::vector<unsigned int> face_nodes(const std::string &face) const override;
    std::vector<std::pair<DofIndex, double>> volume_weights(Component component) const override;
    double dof_scale(DofIndex dof) const override;
    std::string describe_dof(DofIndex dof) const override;
    double stiffness_scale() const override;
    double initial_flow_stress() const override;
    std::vector<double> flow_stress(Side side) const override;
    bool axisymmetric() const override;
    double initial_thickness() const override;
    double typical_length() const override;
    Status assemble(const Vector &q, AssemblyTarget &target) override;
    void assemble_pressure(const Vector &q,
                           const std::string &face,
                           double pressure,
                           bool following,
                           AssemblyTarget &target) const override;
    double admissible_step(const Vector &q, const Vector &dq) const override;
    unsigned int n_contact_nodes(Side side) const override;
    void contact_node(const Vector &q,
                      Side side,
                      unsigned int node,
                      ContactThickness thickness,
                      ContactNode &result) const override;
    const std::vector<std::array<unsigned int, 3>> &contact_edges(Side side) const override;
    void begin_increment(double duration, double ratio) override;
    double flow_error() const override;
    IncrementSize increment_size(const Vector &dq) const override;
    void commit(const Vector &q) override;
    void set_contact_pressure(Side side, const std::vector<double> &pressure) override;
    BlankEnergy energy() const override;
    void forget_energy() override;
    unsigned int n_cells() const override;
    double smallest_thickness() const override;
    Table profile(const Vector &q) const override;
    bool is_sheet() const override
    {
      return true;
    }
    std::vector<SheetSection> sections() const override;
    Drawing draw(const Vector &q, const std::vector<DrawnField> &nodal) const override;
    std::vector<Point2> positions(const Vector &q) const override;
    void rigid_motion(const Vector &q,
                      const Tensor1 &translation,
                      double rotation,
                      const std::function<void(DofIndex, double)> &set) const override;
    KeyedArrays state() const override;
    void set_state(const KeyedArrays &state) override;

  private:
    void set_up_dofs();
    void set_up_points();
    void set_up_nodes();

    template <unsigned int n_nodes, bool membrane>
    Status assemble_cells(const Vector &q, AssemblyTarget &target);

    /// The cells of a picture, by layers, with their fields.
    void draw_cells(const Vector &q, Drawing &drawing) const;

    /// Position of a node and its rotation.
    Point2 position(const Vector &q, unsigned int node) const;
    double rotation(const Vector &q, unsigned int node) const;

    /// Angle of the deformed meridian at a node (the director of a membrane).
    double membrane_angle(const Vector &q, unsigned int node) const;

    /// Generalized strain at a quadrature point.
    ShellStrain strain_at(const Vector &q, unsigned int cell, unsigned int point) const;

    /// Work of the layers, which stand for @p volume each, when the thickness is updated to @p new_ratio: no virtual
    /// work belongs to it.
    double
    thickness_strain_work(unsigned int place, const ShellStrain &strain, double new_ratio, const double *volume) const;

    /// Reference volume that a layer of a point stands for. @param sine of the angle of the undeformed meridian
    double layer_volume(const ShellPoint &point, const double sine, const unsigned int layer) const
    {
      const double along = point.lambda - layer_position_[layer] * point.angle_prime;
      const double around = axisymmetric_ ? point.radius - layer_position_[layer] * sine : 1.;
      return point.weight * layer_weight_[layer] * along * around;
    }

    /// Tributary areas of the nodes at @p q.
    void update_areas(const Vector &q) const;

    /// Average over the adjacent quadrature points, by their share of the reference area.
    std::vector<double> to_nodes(const std::vector<double> &point_values) const;

    // As read
    unsigned int degree_;
    bool axisymmetric_, membrane_, transverse_normal_stress_;
    double thickness_, shear_factor_;
    unsigned int n_layers_;
    ContactPoint contact_point_;
    ShellMesh mesh_;

    // Discretization
    dealii::Triangulation<1, 2> triangulation_;
    std::unique_ptr<dealii::FESystem<1, 2>> element_;
    dealii::DoFHandler<1, 2> dof_handler_;
    std::vector<std::array<DofIndex, 3>> node_dofs_;
    std::vector<bool> is_rotation_;
    std::vector<std::array<unsigned int, 3>> edges_;
    std::vector<double> node_angle_; ///< of the reference tangent, averaged at kinks
    std::vector<double> node_weight_;
    std::vector<bool> weightless_; ///< nodes whose tributary area vanishes: no contact
    unsigned int n_points_per_cell_ = 1;
    std::vector<ShellPoint> points_; ///< cell by cell
    /// Point of the quadrature of loads: shape functions, their derivatives on the unit cell, weight.
    struct LoadPoint
    {
      std::array<double, 3> shape{}, gradient{};
      double weight = 0;
    };
    std::vector<LoadPoint> load_quadrature_;
    std::vector<double> layer_position_, layer_weight_; ///< zeta and its weight, times the thickness

    // State: committed and, where it differs, trial
    MaterialPoints material_; ///< layer by layer, of every quadrature point
    std::vector<Mandel> committed_strain_;
    std::vector<double> thickness_ratio_; ///< committed, per quadrature point
    std::vector<double> node_thickness_; ///< committed
    std::vector<double> node_relief_; ///< elastic part of half of it by the transverse stress
    std::array<std::vector<double>, 2> contact_pressure_; ///< committed, per side and node
    std::vector<double> third_stress_; ///< per layer point of the whole blank
    mutable std::vector<double> node_area_; ///< of the last assembled configuration
  };
} // namespace deltaform
