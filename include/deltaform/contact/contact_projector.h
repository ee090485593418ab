#pragma once

#include <deltaform/assembly/contact_surface.h>
#include <deltaform/contact/flat_edges.h>
#include <deltaform/io/archive.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/tools/tool.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace deltaform
{
  class Section;

  /**
   * Where the contact points of one side of the blank are over a tool: the points as this tool meets them, and their
   * projections on its profile. The last projection of every point is remembered: it starts the next search, and tells
   * which are certainly clear of the tool, as a distance changes at most as fast as the point moves.
   */
  class ContactProjector
  {
  public:
    /// @param tool_section entries on the thickness that keeps the tool from the mid-surface
    ContactProjector(const ContactSurface &surface, const Tool &tool, Section &tool_section);

    const ContactSurface &surface() const
    {
      return surface_;
    }

    const Tool &tool() const
    {
      return tool_;
    }

    unsigned int n_points() const
    {
      return surface_.n_contact_points(tool_.side());
    }

    /// Points that share their unknowns, one after the other: those of an edge; 1 where the nodes are the points.
    unsigned int group() const
    {
      return std::max(1U, surface_.points_per_edge());
    }

    const std::vector<std::array<unsigned int, 3>> &edges() const
    {
      return surface_.contact_edges(tool_.side());
    }

    /// Point @p i as this tool meets it, with its thickness before compression.
    void describe(const Vector &q, unsigned int i, ContactPoint &point) const;

    /// A place of an edge, where contact points lie inside the edges, in the same way.
    ContactPoint place(const Vector &q, unsigned int edge, double xi) const;

    ContactPoint point(const Vector &q, const unsigned int i) const
    {
      ContactPoint result;
      describe(q, i, result);
      return result;
    }

    /// Project point @p i at @p x relative to the tool, and remember it.
    Projection project(unsigned int i, const Point2 &x);

    /// Project a place near point @p i, and remember nothing.
    Projection look(const unsigned int i, const Point2 &x) const
    {
      return tool_.project(x, 0., last_[i].segment);
    }

    /// Is point @p i at @p x certainly more than @p offset away?
    bool certainly_clear(const unsigned int i, const Point2 &x, const double offset) const
    {
      const double clearance = last_[i].distance - offset;
      return clearance > 0 && (x - last_[i].place).norm_square() < clearance * clearance;
    }

    /// How far point @p i at @p x may go and stay certainly clear. Not positive: it is not.
    double clear_way(const unsigned int i, const Point2 &x, const double offset) const
    {
      return last_[i].distance - offset - x.distance(last_[i].place);
    }

    /// Distance at the last projection; -1: none known.
    double last_distance(const unsigned int i) const
    {
      return last_[i].distance;
    }

    /// See FlatEdges.
    ///@{
    void find_flat(const FlatEdges::Points &committed, const double delta)
    {
      flat_.find(*this, committed, delta);
    }

    unsigned int wake_flat(const FlatEdges::Points &trial)
    {
      return flat_.wake(*this, trial);
    }
    ///@}

    /// Point with the smallest gap at @p q when the tool has travelled @p travel, and that gap.
    std::pair<unsigned int, double> closest(const Vector &q, double travel) const;

    /// Distances are no longer known: the tool has moved otherwise, or the points have.
    void discard_distances();

    /// The points are others: each starts from the segment of the old one that @p parents names; none: from nothing.
    void renumber(const std::vector<unsigned int> &parents);
    void reset();

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      const std::size_t n = last_.size();
      archive_plain(archive, last_);
      if (last_.size() != n)
        throw SceneError("The saved state has another number of contact points: it is damaged. Start again.");
    }

  private:
    /// The half thickness on the tool's side as it is without contact, and whether it gives way.
    void release_face(ContactPoint &point) const;

    struct Last
    {
      Point2 place; ///< relative to the tool
      double distance = -1;
      unsigned int segment = invalid_index;
      unsigned int filler = 0; ///< saved as bytes: each one is set
    };

    const ContactSurface &surface_;
    const Tool &tool_;
    ContactThickness thickness_;
    bool gives_way_; ///< the sheet's half thickness on this side is a spring in series with the contact
    std::vector<Last> last_;
    FlatEdges flat_;
  };
} // namespace deltaform
