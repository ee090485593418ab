#pragma once

#include "bend_limit.h"
#include "shell_joining.h"
#include "shell_parts.h"

#include <deltaform/blanks/adaptive.h>
#include <deltaform/blanks/refinement.h>

#include <array>
#include <vector>

namespace deltaform
{
  class Section;

  /// Halving the elements of a shell that bend too sharply while it is formed, and joining the halves where it is
  /// straight again (doc/theory/shell.md).
  class ShellRefinement : public Adaptive
  {
  public:
    ShellRefinement(Section section, const ShellParts &parts);

    /// Is anything ever halved?
    bool active() const
    {
      return limit_.largest() > 0. && !parts_.space().membrane();
    }

    const RefinementSettings &settings() const override
    {
      return settings_;
    }
    std::vector<double> edge_lengths() const override;
    bool mark(const std::array<std::vector<double>, 2> &longest_edges) override;
    void refine(std::vector<Vector> &fields) override;
    bool goes_back() const override
    {
      return true;
    }
    void leave_marked() override;
    double estimated_error() const override;
    unsigned int n_cells() const override;
    const std::vector<PointOrigin> &point_origins(Side side) const override;

    /// An increment was accepted.
    void update(const Vector &q);

    /// Undeformed places of the nodes of the mesh as read.
    const std::vector<Point2> &first_places() const
    {
      return first_.nodes();
    }

    /// Does a state have another mesh than the first?
    static bool is_refined(const KeyedArrays &state);

    /// Put the mesh into a state, or take it from there. @throws SceneError if it is none
    void put(KeyedArrays &state) const;
    void take(const KeyedArrays &state);

  private:
    /// Undeformed.
    double length(unsigned int element) const;

    /// Mark what is much longer than a marked neighbour will be: an element that begins to bend would be a hinge at the
    /// end of one that cannot. @param lengths of the elements, halved where they are marked
    void mark_neighbours(std::vector<double> &lengths);

    /// Would it bend too much if it came to bend as sharply as one of its neighbours that are much shorter?
    bool will_bend(unsigned int element, const std::vector<double> &lengths) const;

    /// @param lengths of the elements, halved where they are marked @return are any to be joined?
    bool mark_to_join(const std::vector<double> &lengths, const std::array<std::vector<double>, 2> &longest_edges);

    /// Which may not be twice as long where they touch a tool, or are about to?
    std::vector<bool> short_for_tools(const std::array<std::vector<double>, 2> &longest_edges) const;

    /// Did halving it fail, and has it not bent much more since? @param by_contact: or is it contact that asks?
    bool left_alone(unsigned int element, bool by_contact) const;

    void set_mesh(const std::vector<ShellMesh::Part> &elements);

    RefinementSettings settings_;
    BendLimit limit_;
    bool joins_;
    double shortest_; ///< undeformed (length)
    ShellParts parts_;
    ShellMesh first_; ///< as read
    std::vector<ShellMesh::Part> elements_; ///< of it, what the elements are
    std::vector<bool> marked_, joined_; ///< to be halved; to be joined with the next one
    std::vector<double> bends_; ///< of the elements, accepted, positive towards the top (rad)
    std::vector<bool> were_bent_; ///< since they are as they are
    std::vector<double> edge_lengths_;

    /// No equilibrium was found when this part of the first mesh was halved, or its halves were joined.
    struct Left
    {
      ShellMesh::Part part;
      double bend; ///< then, regardless of sign (rad)
    };
    std::vector<Left> left_;
    std::vector<Left> tried_; ///< what was halved or joined last
    std::array<std::vector<PointOrigin>, 2> point_origins_;
  };
} // namespace deltaform
