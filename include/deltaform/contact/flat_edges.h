#pragma once

#include <deltaform/assembly/contact_surface.h>
#include <deltaform/contact/contact_point_state.h>
#include <deltaform/tools/tool.h>

#include <vector>

namespace deltaform
{
  class ContactProjector;

  /**
   * Edges with contact points inside them that lie flat on a straight part of the tool. Between two ends that keep
   * delta, all of such an edge does: its outermost points stand for it, with half of its area each, and the points
   * between them are not asked. They would bear what the ends bear, and come and go without end.
   */
  class FlatEdges
  {
  public:
    using Points = std::vector<ContactPointState>;

    /// Find them among @p edges where @p points were accepted; @p delta: the allowed penetration of the increment that
    /// begins. An edge whose inner points carry a force keeps them.
    void find(const ContactProjector &projector,
              const std::vector<unsigned int> &edges,
              const Points &points,
              double delta);

    /// An increment begins: nothing has woken.
    void begin_increment()
    {
      n_wakings_ = 0;
    }

    /// Equilibrium: an edge that is not flat any more has all its points from here on, until the next find(). In a
    /// flange that is pressed each may wake its neighbours: from the third time in an increment on they wake with it,
    /// to twice the reach each time. @return how many edges were not flat any more
    unsigned int wake(const ContactProjector &projector, const Points &trial);

    /// These are, until the next find(); none are where @p flat is empty.
    void set(const std::vector<bool> &flat)
    {
      flat_ = flat;
    }

    /// Edge @p e is none, until it is looked at again.
    void discard(const unsigned int e)
    {
      if (e < flat_.size())
        flat_[e] = false;
    }

    /// Is edge @p e one, so that only its outermost points are asked?
    bool contains(const unsigned int e) const
    {
      return e < flat_.size() && flat_[e];
    }

    /// Where @p points were accepted: was edge @p e flat in the increment that led there? Its points between the
    /// outermost stood for no area then.
    static bool was_flat(const Points &points, const unsigned int per_edge, const unsigned int e)
    {
      return per_edge > 2 && !(points[e * per_edge + 1].area > 0.);
    }

    /// Of every edge.
    static std::vector<bool> were_flat(const Points &points, unsigned int per_edge);

    /// What point @p i of @p surface stands for: its area and compliance.
    void describe(const ContactSurface &surface, Side side, unsigned int i, ContactPoint &point) const;

    /// The same for a point of an edge that is flat.
    static void describe_on_flat(const ContactSurface &surface, Side side, unsigned int i, ContactPoint &point);

  private:
    void wake_neighbours(const ContactProjector &projector, const Points &trial, const std::vector<unsigned int> &woken);

    std::vector<bool> flat_; ///< of every edge; empty: none
    unsigned int n_wakings_ = 0; ///< in this increment
  };
} // namespace deltaform
