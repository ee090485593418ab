#pragma once

#include <deltaform/contact/clear_edges.h>
#include <deltaform/contact/edge_rows.h>
#include <deltaform/contact/point_iteration.h>

#include <vector>

namespace deltaform
{
  /**
   * The iterations of an increment as an interface sees them: all its points, edge by edge. Edges that are certainly
   * clear of the tool are left alone, of flat ones the outermost points are asked, and what an edge has added is added
   * again as long as nothing moves and the same points touch. States come from the interface; what is kept here is
   * discarded when the next increment begins.
   */
  class ContactIteration
  {
  public:
    using Points = PointIteration::Points;
    using Frame = PointIteration::Frame;

    /// @param friction null: none
    ContactIteration(const NormalLaw &law,
                     ContactProjector &projector,
                     const FactorControl &factors,
                     InterfaceFriction *friction);

    void resize(unsigned int n_points);

    /// Number of the first unknown of the law, one per point.
    void set_first_multiplier(const DofIndex first)
    {
      points_.set_first_multiplier(first);
    }

    DofIndex multiplier_dof(const unsigned int i) const
    {
      return points_.multiplier_dof(i);
    }

    void begin_increment()
    {
      restart(true);
    }

    /// The next assembly is anywhere, with trial states that it did not leave. @p at_start: where an increment begins
    void restart(bool at_start = false);

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
    void peel(unsigned int reach, const Points &trial);
    void prepare_step(const Vector &d, const Points &committed, const Points &trial);
    void advance(double factor, Points &trial);

    bool status_changed() const
    {
      return points_.status_changed();
    }

    /// Hash of the set of touching points, as it was assembled last.
    std::size_t signature(const Points &trial) const;

    /// See FactorControl.
    unsigned int correct_early(Points &trial);

    const Tensor1 &tool_force() const
    {
      return tool_force_;
    }

    std::vector<Frame> frames(const Points &trial) const
    {
      return points_.frames(trial);
    }
    ///@}

    /// The trial state is accepted: locate the points that assembly did not look at. @return edges that are far from
    /// here on (FarEdges), whose points stay where they are
    std::vector<EdgeClearance> complete(const Vector &q, const Tensor1 &shift, const Points &committed, Points &trial);

    /// Edge @p e is no longer far: nothing is known of its points.
    void renew(unsigned int e);

    /// Of flat edges that touch only.
    void complete_flat(const Vector &q, const Tensor1 &shift, Points &trial);

    /// A touching point, as it was assembled last.
    const ContactPoint &touching_point(const unsigned int i) const
    {
      return points_.point(i);
    }

  private:
    /// Points inside an edge, at the last assembly.
    struct Edge
    {
      EdgeRows rows;
      bool known = false; ///< the rows are those that the points would add again, if nothing moves
      std::size_t touching = 0; ///< hash of those that touch; 0: none
      Tensor1 tool_force;
    };

    /// From one point of edge @p e that is asked to the next.
    unsigned int stride(const unsigned int e) const
    {
      return every_point_ ? 1 : projector_.stride(e);
    }

    /// @p action(i) for the points of edge @p e that are asked; a node is an edge of its own.
    template <typename Action>
    void for_points(unsigned int e, const Action &action) const;

    /// The same of all edges that may touch.
    template <typename Action>
    void for_points(const Action &action) const;

    /// What an edge adds, and whether it is clear, has to be found again: its set of touching points is another one.
    void look_again(const unsigned int e)
    {
      clear_.discard(e);
      if (!edges_.empty())
        edges_[e].known = false;
    }

    /// Points from @p first to @p end, which no assembly asks.
    void locate(unsigned int first, unsigned int end, const Vector &q, const Tensor1 &shift, Points &trial) const;

    /// Residual and tangent of the points of edge @p e.
    void assemble_edge(unsigned int e,
                       const Vector &q,
                       const Tensor1 &shift,
                       const Points &committed,
                       Points &trial,
                       bool tangent);

    /// Was edge @p e, which is clear, clear when the increment began, and is it far now?
    bool is_far(unsigned int e, const Vector &q, const Tensor1 &shift, const Points &committed) const;

    /// The points of edge @p e were assembled: can they be left alone from now on?
    void find_clear(unsigned int e, const Vector &q, const Tensor1 &shift, const Points &trial);

    const NormalLaw &law_;
    ContactProjector &projector_;
    const FactorControl &factors_;
    InterfaceFriction *friction_; ///< null: none
    PointIteration points_;
    unsigned int group_ = 1; ///< points of an edge; a node is alone
    bool every_point_ = true; ///< is every one asked? An unknown of its own asks for its equation
    std::vector<Edge> edges_; ///< empty if nodes touch
    ClearEdges clear_;
    Tensor1 tool_force_;
  };
} // namespace deltaform
