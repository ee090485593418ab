#pragma once

#include <deltaform/assembly/contact_surface.h>
#include <deltaform/assembly/point_origin.h>
#include <deltaform/contact/counterpart.h>
#include <deltaform/contact/far_edges.h>
#include <deltaform/contact/flat_edges.h>
#include <deltaform/contact/moving_points.h>
#include <deltaform/io/archive.h>
#include <deltaform/parameters/scene_error.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace deltaform
{
  class Section;

  /**
   * Where the contact points of one side of the blank are over their counterpart: the points as it meets them, and
   * their projections on its profile. The last projection of every point is remembered: it starts the next search, and
   * tells which are certainly clear, as a distance changes at most as fast as the point moves.
   */
  class ContactProjector
  {
  public:
    /// @param section entries on the thickness that keeps the counterpart from the mid-surface
    ContactProjector(const ContactSurface &surface, Side side, const Counterpart &counterpart, Section &section);

    /// Does a shell give way through its thickness? @param section of the tool
    static bool reads_compliance(Section &section);

    const ContactSurface &surface() const
    {
      return surface_;
    }

    /// Of the blank.
    Side side() const
    {
      return side_;
    }

    const Counterpart &counterpart() const
    {
      return counterpart_;
    }

    unsigned int n_points() const
    {
      return surface_.n_contact_points(side_);
    }

    /// Points that share their unknowns, one after the other: those of an edge; 1 where the nodes are the points.
    unsigned int group() const
    {
      return std::max(1U, surface_.points_per_edge());
    }

    const std::vector<std::array<unsigned int, 3>> &edges() const
    {
      return surface_.contact_edges(side_);
    }

    /// Point @p i as the counterpart meets it, with its thickness before compression.
    void describe(const Vector &q, unsigned int i, ContactPoint &point) const;

    /// Point @p i with the area that bore its force in the increment that ended at @p accepted: which edges are flat
    /// (FlatEdges) changes when the next one begins.
    ContactPoint accepted_point(const Vector &q, unsigned int i, const FlatEdges::Points &accepted) const;

    /// Where it is, with area and thickness, but without its row (ContactSurface::locate_point()).
    void locate(const Vector &q, unsigned int i, ContactPoint &point) const;

    /// A place of an edge, where contact points lie inside the edges, in the same way.
    ContactPoint place(const Vector &q, unsigned int edge, double xi) const;

    /// Where it is, without its row.
    void locate(const Vector &q, unsigned int edge, double xi, ContactPoint &place) const;

    ContactPoint point(const Vector &q, const unsigned int i) const
    {
      ContactPoint result;
      describe(q, i, result);
      return result;
    }

    /// Project point @p i at @p x relative to the counterpart, and remember it.
    Projection project(unsigned int i, const Point2 &x);

    /// Project a place near point @p i, and remember nothing.
    Projection look(const unsigned int i, const Point2 &x) const
    {
      return counterpart_.project(x, last_[i].segment);
    }

    /// By how much the gap grows along the face at point @p i, whose projection is @p closest, over a way along growing
    /// arc length of the tool. 0 where a smooth face touches, and where the surface tells no direction.
    double slope(const Vector &q, unsigned int i, const Projection &closest) const;

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

    /// @name See MovingPoints
    ///@{
    MovingPoints &moving()
    {
      return moving_;
    }
    const MovingPoints &moving() const
    {
      return moving_;
    }

    /// Point @p i when the increment began, in the place of the sheet where it was accepted.
    ContactPoint start(unsigned int i) const;
    ///@}

    /// See FlatEdges.
    ///@{
    void begin_increment(const FlatEdges::Points &committed, const double delta)
    {
      flat_.begin_increment();
      find_flat(near_edges(), committed, delta);
    }
    void find_flat(const std::vector<unsigned int> &edges, const FlatEdges::Points &committed, const double delta)
    {
      flat_.find(*this, edges, committed, delta);
    }

    /// From one point of edge @p e that is asked to the next: of a flat one only the outermost are.
    unsigned int stride(const unsigned int e) const
    {
      return flat_.contains(e) ? group() - 1 : 1;
    }

    unsigned int wake_flat(const FlatEdges::Points &trial)
    {
      return flat_.wake(*this, trial);
    }
    ///@}

    /// @name See FarEdges; a node is an edge of its own
    ///@{
    FarEdges &far()
    {
      return far_;
    }
    const FarEdges &far() const
    {
      return far_;
    }

    /// All edges are near.
    void look_at_all()
    {
      far_.reset(n_points() / group());
    }

    /// These are far from here on, and count as not flat.
    void leave(const std::vector<EdgeClearance> &edges);

    const std::vector<unsigned int> &near_edges() const
    {
      return far_.near();
    }

    /// @p action(i) for the points of near edges, ascending.
    template <typename Action>
    void for_near_points(const Action &action) const
    {
      const unsigned int n = group();
      for (const unsigned int e : far_.near())
        for (unsigned int i = e * n; i < (e + 1) * n; ++i)
          action(i);
    }
    ///@}

    /// Point with the smallest gap at @p q when the counterpart has gone by @p way, and that gap.
    std::pair<unsigned int, double> closest(const Vector &q, const Tensor1 &way) const;

    /// Distances are no longer known: the counterpart has moved otherwise, or the points have.
    void discard_distances();

    /// The points are others: each starts from the segment of the old one that @p origins names. @p flat: which edges
    /// are flat; none are where it is empty.
    void renumber(const std::vector<PointOrigin> &origins, const std::vector<bool> &flat);

    /// The points are others and start from nothing.
    void reset();

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      const std::size_t n = last_.size();
      archive_plain(archive, last_);
      if (last_.size() != n)
        throw SceneError("The saved state has another number of contact points: it is damaged. Start again.");
      archive &far_;
      archive &moving_;
    }

  private:
    /// The half thickness on this side as it is without contact, and whether it gives way.
    void release_face(ContactPoint &point) const;

    /// Where points move: the place of the sheet at @p xi as point @p i. @p point is the place.
    void set_moving(unsigned int i, double xi, ContactPoint &point) const;

    struct Last
    {
      Point2 place; ///< relative to the counterpart
      double distance = -1;
      unsigned int segment = invalid_index;
      unsigned int filler = 0; ///< saved as bytes: each one is set
    };

    const ContactSurface &surface_;
    Side side_;
    const Counterpart &counterpart_;
    ContactThickness thickness_;
    bool gives_way_; ///< the sheet's half thickness on this side is a spring in series with the contact
    std::vector<Last> last_;
    FlatEdges flat_;
    FarEdges far_;
    MovingPoints moving_;
  };
} // namespace deltaform
