#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/contact/clear_edges.h>
#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/edge_rows.h>
#include <deltaform/contact/factor_control.h>
#include <deltaform/contact/interface_friction.h>
#include <deltaform/contact/normal_law.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace deltaform
{
  /**
   * The iterations of an increment as an interface sees them: forces and status of its points at the present unknowns,
   * what they add to residual and tangent, and what a Newton step makes of the estimates of lambda. States come from
   * the interface; what is kept here is discarded when the next increment begins.
   */
  class ContactIteration
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
    ContactIteration(const NormalLaw &law,
                     ContactProjector &projector,
                     const FactorControl &factors,
                     const InterfaceFriction *friction);

    void resize(unsigned int n_points);

    /// Number of the first unknown of the law, one per point.
    void set_first_multiplier(const DofIndex first)
    {
      first_multiplier_ = first;
    }

    DofIndex multiplier_dof(const unsigned int i) const
    {
      return first_multiplier_ + i;
    }

    void begin_increment()
    {
      restart();
      at_start_ = true;
    }

    /// The next assembly is anywhere, with trial states that it did not leave.
    void restart();

    /// Points have other penalty factors than in the last assembly.
    void discard_rows();

    /// Residual and tangent of all points at @p q. @p shift: way of the counterpart. @p time: end of the increment
    void assemble(const Vector &q,
                  const Tensor1 &shift,
                  double time,
                  const Points &committed,
                  Points &trial,
                  AssemblyTarget &target);

    /// See ContactInterface.
    ///@{
    bool foresee(const Vector &q, const Tensor1 &shift, const Vector &d, const Points &trial);
    void prepare_step(const Vector &d, const Points &committed, const Points &trial);
    void advance(double factor, Points &trial);

    bool status_changed() const
    {
      return status_changed_;
    }

    /// Hash of the set of touching points, as it was assembled last.
    std::size_t signature(const Points &trial) const;

    const Tensor1 &tool_force() const
    {
      return tool_force_;
    }

    std::vector<Frame> frames(const Points &trial) const;
    ///@}

    /// The trial state is accepted: describe the points that assembly did not look at.
    void complete(const Vector &q, const Tensor1 &shift, Points &trial);

    /// Of flat edges that touch only.
    void complete_flat(const Vector &q, const Tensor1 &shift, Points &trial);

    /// A touching point, as it was assembled last.
    const ContactPoint &touching_point(const unsigned int i) const
    {
      return work_[i].point;
    }

  private:
    /// What is computed of a point in an iteration and discarded.
    struct Work
    {
      ContactPoint point; ///< at the last assembly
      Projection projection; ///< the same, of a point that may have contact
      bool is_near = false; ///< it may have contact: it was projected
      std::optional<bool> foreseen; ///< will it touch? See ContactInterface::foresee()
      double base_multiplier = 0, step_multiplier = 0; ///< estimates of lambda along a Newton step
    };

    /// Points inside an edge, at the last assembly.
    struct Edge
    {
      EdgeRows rows;
      bool known = false; ///< the rows are those that the points would add again, if nothing moves
      std::size_t touching = 0; ///< hash of those that touch; 0: none
      Tensor1 tool_force;
    };

    /// From one point of edge @p e that is asked to the next. An unknown of its own asks for its equation.
    unsigned int stride(const unsigned int e) const
    {
      return law_.has_multiplier() ? 1 : projector_.stride(e);
    }

    /// @p action(i) for all points that are asked, of edges that may touch.
    template <typename Action>
    void for_each_asked(const Action &action) const;

    /// Points that no assembly asks, from @p first on in steps of 1, up to @p end.
    void describe(unsigned int first, unsigned int end, const Vector &q, const Tensor1 &shift, Points &trial);

    /// Of a point relative to the counterpart in the step @p d.
    Tensor1 motion(unsigned int i, const Vector &d) const;

    /// Residual and tangent of the points of edge @p e.
    void assemble_edge(unsigned int e,
                       const Vector &q,
                       const Tensor1 &shift,
                       const Points &committed,
                       Points &trial,
                       bool tangent);

    /// Residual and tangent of a point.
    void assemble(unsigned int i,
                  const Vector &q,
                  const Tensor1 &shift,
                  const Points &committed,
                  Points &trial,
                  AssemblyTarget &target);

    /// Will a point change its status in the step @p d?
    bool foresee(unsigned int i, const Vector &d, const ContactPointState &state);

    /// The points of edge @p e were assembled: can they be left alone from now on?
    void find_clear(unsigned int e, const Vector &q, const Tensor1 &shift, const Points &trial);

    /// A point that has no contact, whatever its force was.
    void leave(unsigned int i, const Vector &q, ContactPointState &state, AssemblyTarget &target);

    /// A point that may have contact. @p known: its projection is
    void meet(unsigned int i,
              bool known,
              const Vector &q,
              const Points &committed,
              Points &trial,
              AssemblyTarget &target);

    /// Add the forces of a point.
    void add(unsigned int i,
             const ContactPoint &point,
             const Projection &projection,
             const NormalResponse &normal,
             const FrictionResponse &friction,
             ContactPointState &state,
             AssemblyTarget &target);

    const NormalLaw &law_;
    ContactProjector &projector_;
    const FactorControl &factors_;
    const InterfaceFriction *friction_;
    DofIndex first_multiplier_ = dealii::numbers::invalid_dof_index;

    std::vector<Work> work_;
    std::vector<Edge> edges_; ///< empty if nodes touch
    ClearEdges clear_;
    bool status_changed_ = false;
    bool in_place_ = false; ///< no step has been made since the last assembly: points are described as it left them
    bool at_start_ = false; ///< no step has been made in this increment: points touch that did in the last one
    Tensor1 tool_force_;
  };
} // namespace deltaform
