#pragma once

#include <deltaform/base/archive.h>
#include <deltaform/base/assembly_target.h>
#include <deltaform/base/energy.h>
#include <deltaform/base/section.h>
#include <deltaform/base/stiffness_view.h>
#include <deltaform/contact/enforcement.h>
#include <deltaform/contact/friction_law.h>
#include <deltaform/contact/penalty_rule.h>
#include <deltaform/kinematics/contact_surface.h>
#include <deltaform/tools/tool.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /// Entries of the Contact section that all pairs share.
  struct ContactSettings
  {
    explicit ContactSettings(Section &section, const std::map<std::string, double> &constants);

    std::unique_ptr<Enforcement> enforcement;
    std::unique_ptr<PenaltyRule> rule;
    TimeFunction allowed_penetration;
    TimeFunction allowed_slip;
    double tangential_factor;
    double tangential_floor;
  };

  /**
   * One side of the blank against one tool: the loop over the nodes, with trial and committed state. Forces on the
   * blank are lambda N - t s tau with N the normal, tau the tangent of the tool and s = d(foot point)/d(node),
   * averaged: derivation of residual and tangent in doc/theory/contact.md.
   */
  class ContactPair
  {
  public:
    ContactPair(const ContactSurface &surface, Tool &tool, const ContactSettings &settings, Section tool_section);

    const Tool &tool() const
    {
      return tool_;
    }

    /// Null: without friction.
    const FrictionLaw *friction() const
    {
      return friction_.get();
    }

    DofIndex travel_dof() const
    {
      return travel_dof_;
    }

    /// Where node @p i has its multiplier, if the enforcement has any.
    DofIndex multiplier_dof(const unsigned int i) const
    {
      return first_multiplier_ + i;
    }

    unsigned int n_nodes() const
    {
      return surface_.n_contact_nodes(tool_.side());
    }

    /// Number the unknowns of this pair: the travel of a force-driven tool, and one multiplier per node if the
    /// enforcement has them.
    void set_dofs(DofIndex travel, DofIndex first_multiplier);

    /// Begin a stage at @p q and @p time: remember where the nodes are, so that the slip of a first touch is known.
    void begin_stage(const Vector &q, double time);

    /// Start an increment that ends at @p time: trial state from the committed one, allowed penetrations.
    void begin_increment(double time);

    /// Continuation: pairs that did not touch at the start of the increment begin with this share of their factor
    /// (active set: of their nodal stiffness) and are stiffened to the full after each converged solve.
    void soften(const double share)
    {
      softening_ = share;
    }

    /// Store the blank's nodal stiffness blocks for the rule; contact has not yet been added to @p stiffness.
    void read_stiffness(const Vector &q, const StiffnessView &stiffness);

    /// Add C (p - delta) of the touching pairs, for the rule's coupling.
    void add_mismatch(const Vector &q, Vector &direction) const;

    /// Give every touching pair its factor: @p coupling = K C (p - delta), or null if no rule needs it.
    void predict_factors(const Vector &q, const Vector *coupling);

    /// Residual and tangent of all pairs at @p q.
    void assemble(const Vector &q, AssemblyTarget &target);

    /// A Newton step @p d was computed from the last assembled state: what it makes of the forces.
    void prepare_step(const Vector &d);

    /// The step is taken by this factor; the next assembly is at the new place.
    void advance(double factor);

    /// Did a node gain or lose contact in the last assembly?
    bool status_changed() const
    {
      return status_changed_;
    }

    /// How far the tool can go before it touches, by the gaps of the last assembly; 0 if it touches.
    double free_travel() const;

    /// Is no force tensile? Otherwise the state is not a solution, however small the residual.
    bool consistent(double allowed_tension) const;

    /**
     * After convergence: let the rule correct the factors. @return the number of pairs whose factor has changed.
     */
    unsigned int correct_factors();

    /// Shifts of all pairs, and the forces that augmentation makes of them (Uzawa). @return whether all gaps are small
    /// enough, with the tolerance times @p relaxation (at most delta)
    bool augmentation(std::vector<double> &shifts, std::vector<double> &forces, double relaxation) const;

    /// Set the shifts of all pairs, from @p next on. @return the position behind them
    const double *shift(const double *next);

    /// The pair that breaks the promise most, beyond round-off: node and p/delta (invalid_index: none does).
    std::pair<unsigned int, double> broken_promise() const;

    void commit(const Vector &q);

    /// After the blank's thickness was updated: new gaps at the same positions.
    void refresh(const Vector &q);

    /// Where the tool is: travel at the trial state.
    double travel(const Vector &q) const;

    /// Force of the blank on the tool in the trial state (full circumference or per unit width).
    const Tensor1 &tool_force() const
    {
      return tool_force_;
    }

    /// Trial and committed state of every node, and the nodes' description.
    const std::vector<PairState> &trial() const
    {
      return trial_;
    }

    const std::vector<PairState> &committed() const
    {
      return committed_;
    }

    ContactEnergy energy() const;

    /// Nobody asks for energies: they are zero from here on, and cost nothing.
    void forget_energy();

    /// Largest penetration anywhere along the edges, not only at the nodes.
    double penetration_between_nodes(const Vector &q) const;

    /// Contact pressure of every node (committed force over current tributary area).
    std::vector<double> pressure(const Vector &q) const;

    /// Until the end of this increment a pair with a smaller force than @p force, pressure or tension, stays what it
    /// is, touching or not. Where a flat part of the blank lies on a flat tool no pair carries a force; all states are
    /// solutions, and the iteration would choose among them for ever.
    void allow_slack(const double force)
    {
      slack_ = std::max(slack_, force);
    }

    unsigned int n_touching() const;

    /// Displacement unknowns of a touching node and the tool's normal there.
    struct Frame
    {
      DofIndex r, z;
      Tensor1 normal;
    };

    /// Of all touching nodes, as assembled last.
    std::vector<Frame> frames() const;

    /// Is the floor larger than what delta asks for at this node?
    bool governed_by_floor(unsigned int node) const;

    ContactNode node(const Vector &q, unsigned int i) const;

    /// Node with the smallest gap at @p q when the tool has travelled @p travel, and that gap.
    std::pair<unsigned int, double> closest(const Vector &q, double travel) const;

    /// The blank has other nodes than before: pairs of all of them, without contact.
    void resize();

    /// Lower the longest allowed undeformed length of each edge of the side where it touches, or is about to touch, a
    /// round part of the tool, so that its present length is @p share of the radius at most (0: nowhere). To 0 where no
    /// node has noticed the tool yet, and, if @p rim, where contact ends inside the edge.
    void shorten_edges(double share, bool rim, std::vector<double> &longest) const;

    /**
     * The blank was refined at the committed @p q: new nodes take over forces and factors per area, penetrations and
     * slip from the two old ones that @p heritage names, if both touch. What that adds to the stored energy counts as
     * work of changing factors.
     */
    void inherit(const Vector &q, const std::vector<std::array<unsigned int, 2>> &heritage);

    /// Multiplier unknowns that belong to the committed forces.
    void start_multipliers(Vector &q) const;

    /// The tool leaves: hand the forces of the accepted equilibrium over to @p target and forget all contact. They are
    /// those that were in balance; the law evaluated again would find others, because the thickness was updated since.
    void release(const Vector &q, AssemblyTarget &target);

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      // Everything that an increment finds: also what only saves a projection, or a resumed run may differ in a last
      // digit from one that was not interrupted.
      archive_plain(archive, committed_);
      archive_plain(archive, stiffness_);
      archive_plain(archive, committed_x_);
      archive_plain(archive, projected_x_);
      archive_plain(archive, committed_residual_);
      ContactEnergy total = energy();
      archive &area_ &thickness_of_ &projected_gap_ &noise_ &hint_ &time_ &last_time_ &last_step_;
      archive &total.stored &total.friction &total.friction_variance &total.epsilon &total.thickness;
      if (energy_)
        energy_ = total;
    }

  private:
    /// Is the contact point certainly clear of the tool? The distance changes at most as fast as the point moves.
    bool certainly_clear(unsigned int i, const Point2 &relative, double offset) const;

    /// The node as this pair sees it: the thickness that gives way at once is not yet taken off.
    void describe(const Vector &q, unsigned int i, ContactNode &node) const;

    /// K_nn (or K_tt) = (J^T n)^T K (J^T n) with the nodal block of the blank's tangent.
    double nodal_stiffness(unsigned int i, const ContactNode &node, const Tensor1 &direction) const;

    /// Status and normal force of pair @p i at the gap that decides (of a penalty spring: its share of it).
    NormalResponse respond(unsigned int i, double gap) const;

    /// Is the force of the pair, estimated and now, within the slack?
    bool is_idle(const PairState &state, double gap) const;

    /// Smallest radius of the tool that an edge touches or is about to touch, also between its ends; 0: a sharp corner;
    /// infinity: none.
    double radius_along(const std::array<unsigned int, 3> &edge) const;

    /// Does an edge of a solid overlap with the tool although none of its nodes touches?
    bool missed(const std::array<unsigned int, 3> &edge) const;

    double neighbour_factor(unsigned int i) const;

    PenaltyInput input(unsigned int i, const PairState &state, double coupling) const;

    /// By how much the reaction is expected to grow in this increment: as in the last one, at most to twice itself. A
    /// factor for the force of the last increment alone is too soft for a growing one and costs a correction.
    double expected_growth(unsigned int i) const;

    /// Tangential factor from the allowed elastic slip; @p stiffness of the node along the tool.
    double tangential_factor(unsigned int i, double stiffness) const;

    /// What the law may know of pair @p i with a normal force; its slip is not yet set.
    FrictionInput friction_input(unsigned int i, double normal_force) const;

    FrictionResponse friction_response(unsigned int i,
                                       const ContactNode &node,
                                       const Projection &projection,
                                       const NormalResponse &normal) const;

    /// First touch of a pair within this increment: factors, and where its slip starts.
    void touch(unsigned int i, const ContactNode &node, const Projection &projection);

    /// Estimate of the discretisation error in the contact surface, as a length (doc/theory/contact.md).
    double automatic_delta() const;

    /// By how much a penetration may exceed delta before the promise is broken: 1e-6 delta or round-off.
    double tolerance(unsigned int i) const;

    /// Of a change of the distance between tool and mid-surface, the share that the penalty spring takes; the sheet, a
    /// spring in series with it, takes the rest.
    static double spring_share(const PairState &state, const double compliance)
    {
      return 1. / (1. + state.epsilon * compliance);
    }

    /// How far the face of the blank is from the contact point, squeezed by the pair's force.
    double face(const ContactNode &node, const PairState &state) const
    {
      return node.offset - (state.touching ? node.squeeze * state.force : 0.);
    }

    /// Share of the friction force that a node with this offset receives, which is its slip per tangential motion.
    double slip_share(const Projection &projection, double offset) const;

    /// Slip in this increment of a pair that touches or did at its start, over the whole increment: a length along the
    /// tool.
    double slip_of_increment(const Vector &q, unsigned int i) const;

    /// Count the friction work of a pair over a @p slip. @return by how much the force at the end would have done more
    /// over it than the one at the start
    double dissipate(const PairState &before, const PairState &now, double slip);

    void update_stored_energy();

    /// Are the pairs springs that keep their penetration? Augmented ones end without, like exact constraints.
    bool stores_energy() const
    {
      return settings_.enforcement->augmentation_tolerance() == 0;
    }

    void add_pair(unsigned int i,
                  const ContactNode &node,
                  const Projection &projection,
                  const NormalResponse &normal,
                  const FrictionResponse &friction,
                  AssemblyTarget &target);

    const ContactSurface &surface_;
    Tool &tool_;
    const ContactSettings &settings_;
    std::unique_ptr<FrictionLaw> friction_;
    ContactThickness thickness_;
    bool squeezed_ = false; ///< the sheet's half thickness on this side is a spring of the pair

    DofIndex travel_dof_ = dealii::numbers::invalid_dof_index;
    DofIndex first_multiplier_ = dealii::numbers::invalid_dof_index;
    double time_ = 0;
    double last_time_ = 0, last_step_ = 0; ///< end and length of the last accepted increment

    std::vector<PairState> committed_, trial_;
    /// What a pair adds to the residual in the rows of its node's unknowns: accepted, and as assembled last.
    std::vector<std::array<double, ContactNode::max_dofs>> committed_residual_, residual_;
    std::vector<double> area_, thickness_of_; ///< of the last assembled configuration
    std::vector<double> flow_stress_; ///< accepted, of the blank's surface; empty if the law of friction does not ask
    std::vector<std::array<double, 9>> stiffness_; ///< nodal blocks of the blank's tangent
    std::vector<Point2> committed_x_; ///< contact point relative to the tool at the last commit
    std::vector<Point2> x_; ///< the same at the last assembly
    std::vector<Point2> projected_x_; ///< the same at the last projection
    std::vector<double> projected_gap_; ///< distance then; -1: none known
    std::vector<double> noise_; ///< round-off of the gap, which is a difference of large numbers
    std::vector<unsigned int> hint_; ///< segment of the last projection
    bool status_changed_ = false;
    bool at_start_ = false; ///< no step has been made in this increment: only the last one knows who touches
    double slack_ = 0; ///< see allow_slack()
    double median_factor_ = 0;
    double softening_ = 1; ///< share of the factor of first touches, see soften()
    double slip_limit_ = 0; ///< allowed elastic slip at the end of the increment
    std::vector<ContactNode> description_; ///< of touching nodes at the last assembly
    std::vector<Tensor1> normal_; ///< the same
    std::vector<double> base_multiplier_, step_multiplier_; ///< estimates of lambda along a Newton step
    Tensor1 tool_force_;
    std::optional<ContactEnergy> energy_ = ContactEnergy(); ///< none if nobody asks
  };
} // namespace deltaform
