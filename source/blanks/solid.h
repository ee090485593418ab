#pragma once

#include "material_points.h"
#include "solid_boundary.h"
#include "solid_face.h"
#include "solid_points.h"
#include "solid_space.h"

#include <deltaform/blanks/blank.h>
#include <deltaform/blanks/refinement.h>


#include <functional>
#include <limits>

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
    /// A rotation in the plane, by cosine and sine of twice its angle, as it turns a stress.
    struct Turn
    {
      double cosine = 1, sine = 0;
    };

    explicit Solid(Section &section);

    unsigned int n_dofs() const override;
    dealii::IndexSet locally_owned_dofs() const override;
    void add_couplings(dealii::DynamicSparsityPattern &pattern) const override;
    std::vector<DofIndex> fixed_dofs() const override;
    std::vector<DofIndex> boundary_dofs(const std::string &boundary, Component component) const override;
    std::vector<std::string> boundaries() const override;
    std::vector<Point2> boundary_points(const std::string &boundary) const override;
    std::vector<double> boundary_weights(const std::string &boundary) const override;
    std::vector<std::string> faces() const override;
    std::vector<unsigned int> face_nodes(const std::string &face) const override
    {
      return boundary_.nodes(face);
    }
    std::vector<std::pair<DofIndex, double>> volume_weights(Component component) const override;
    double dof_scale(DofIndex dof) const override;
    std::string describe_dof(DofIndex dof) const override;
    double stiffness_scale() const override;
    double initial_flow_stress() const override;
    std::vector<double> flow_stress(Side side) const override;
    double modulus() const override;
    bool constant_stiffness() const override;
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
    double smallest_thickness() const override;
    Table profile(const Vector &q) const override;
    Drawing draw(const Vector &q, const std::vector<DrawnField> &nodal) const override;
    std::vector<Point2> positions(const Vector &q) const override;
    void rigid_motion(const Vector &q,
                      const Tensor1 &translation,
                      double rotation,
                      const std::function<void(DofIndex, double)> &set) const override;
    const RefinementSettings *refinement() const override;
    bool mark(const std::array<std::vector<double>, 2> &longest_edges) override;
    void refine(std::vector<Vector> &fields) override;
    double estimated_error() const override;
    unsigned int n_cells() const override;
    const std::vector<std::array<unsigned int, 2>> &heritage(Side side) const override;
    KeyedArrays state() const override;
    void set_state(const KeyedArrays &state) override;

  private:
    /// State of points that never strained, on the cells as they are now.
    void set_up_state();

    /// Small strain, a law without history, and the same moduli at zero and at some strain?
    bool has_linear_law() const;

    /// Estimated squared error in energy of every cell, and the relative one of the whole.
    struct ErrorEstimate
    {
      std::vector<double> squares;
      double relative = 0;
    };
    ErrorEstimate estimate_error() const;

    /// Bilinear function of a corner of the cell at a quadrature point.
    double corner_shape(unsigned int point, unsigned int vertex) const;

    /// Places, values of fields (with hanging nodes), and plastic state of a cell; what a child makes of them.
    std::vector<double> pack(unsigned int cell, const std::vector<Vector> &fields) const;
    std::vector<double> inherit(const std::vector<double> &parent, unsigned int child) const;
    void unpack(const std::vector<std::vector<double>> &data, std::vector<Vector> &fields);

    /// Halve the marked cells, share all among the processes anew and hand on what the own cells know.
    std::vector<std::vector<double>> divide_cells(const std::vector<std::vector<double>> &own);

    /// Are the points of the children of a cell, at the committed displacements, not turned inside out? The points of
    /// the cell itself may all be right where a corner of it is folded.
    bool divisible(unsigned int cell) const;

    /// Flag the @p marked cells that can be divided, and with them what their neighbours need. @return whether any is
    bool flag_divisible(std::vector<bool> &marked);

    /// Estimated squared errors of all processes' cells above which a cell is refined.
    double error_threshold(const std::vector<double> &squares) const;

    void update_areas(const Vector &q) const;

    /// The own cells, whatever other processes find in theirs.
    Status assemble_own_cells(const Vector &q, AssemblyTarget &target);

    template <unsigned int n_nodes, unsigned int n_points>
    Status assemble_cells(const Vector &q, AssemblyTarget &target);
    Status assemble_all(const Vector &q, AssemblyTarget &target);

    /// Small strain and a law that is linear: every cell's matrix is kept from the first pass, no law is asked again.
    Status assemble_constant(const Vector &q, AssemblyTarget &target);
    void update_stress(const Vector &q);

    /// C_p^-1 of a point whose logarithmic elastic strain has the deviator of @p elastic.
    void set_plastic_metric(unsigned int point, Mandel elastic);

    /// Make the elastic strains of all points, at the displacements of the last pass, the @p wanted ones as far as
    /// metal has flowed there: by the plastic strain and, for the volume, by volume_offset_.
    void keep_elastic_strain(const std::vector<Mandel> &wanted);

    /// Logarithmic strain ln(F F^T)/2, of small kinematics the symmetric part of the displacement gradient.
    Mandel total_strain(const Deformation &F) const;

    /// Committed logarithmic plastic strain -ln(C_p^-1)/2 of a point of the blank, turned with the material by @p F; of
    /// small kinematics the one of the history.
    Mandel plastic_strain(unsigned int point, const Deformation &F) const;

    /// Mean over points of a cell of what else the law remembers, as it is drawn (a tensor: rr, zz, hoop, rz).
    std::vector<double> remembered(const HistoryField &field, unsigned int first_point, unsigned int n_points) const;

    /// The cells of a picture with their fields; @p q with hanging nodes.
    void draw_cells(const Vector &q, Drawing &drawing) const;

    /// Deformation from the committed to the trial state at a point of the whole blank.
    Deformation increment(unsigned int point) const;

    void update_thickness(const Vector &q);
    void update_places(const Vector &q);

    // As read
    unsigned int degree_;
    bool axisymmetric_, finite_;
    RefinementSettings refinement_;
    std::array<std::vector<std::string>, 2> contact_boundaries_;

    // Discretization
    SolidSpace space_;
    SolidPoints points_;
    SolidBoundary boundary_;
    std::array<SolidFace, 2> faces_; ///< bottom, top
    bool linear_ = false; ///< small strain, and moduli that do not depend on the strain
    std::vector<double> constant_matrices_; ///< of linear_, cell by cell
    double shortest_edge_ = 0, outermost_ = 0;

    // Refinement so far
    std::vector<std::vector<bool>> passes_; ///< which cells were refined, pass by pass
    std::array<std::vector<std::array<unsigned int, 2>>, 2> heritage_;
    double estimated_error_ = std::numeric_limits<double>::quiet_NaN();

    // State: committed and, where it differs, trial
    MaterialPoints material_; ///< cell by cell
    std::vector<Turn> spin_; ///< how far the last increment turned each point; if the law goes on from the last flow
    std::vector<Deformation> deformation_, committed_deformation_;
    std::vector<std::array<double, 4>> plastic_metric_; ///< committed C_p^-1: rr, zz, hoop, rz
    std::vector<double> volume_offset_; ///< volumetric strain without stress that a refinement left, in the projection
    std::vector<Point2> committed_places_; ///< of the nodes, for marking
    double smallest_thickness_ = 0;
  };
} // namespace deltaform
