#pragma once

#include <deltaform/contact/contact_projector.h>
#include <deltaform/contact/interface_state.h>
#include <deltaform/parameters/scene_error.h>

#include <vector>

namespace deltaform
{
  /// The states of an interface, accepted and on trial, and how one begins or ends with the other. Of far edges
  /// (FarEdges) nothing is touched.
  class InterfaceStates
  {
  public:
    explicit InterfaceStates(ContactProjector &projector)
      : projector_(projector)
    {
    }

    InterfaceState committed, trial;

    /// Allowed penetration of the increment that was begun last (length).
    double delta() const
    {
      return delta_;
    }

    /// Points of a new surface, without contact.
    void resize();

    /// A stage begins at @p q and @p time, with the tool at @p way: points are where they are, so that the slip of a
    /// first touch is known.
    void begin_stage(const Vector &q, double time, const Tensor1 &way);

    /// An increment begins at the committed @p q, with the tool at @p way. @return edges that are no longer far
    std::vector<unsigned int> look_at_near(const Vector &q, const Tensor1 &way);

    /// It will end at @p time; the trial points are the committed ones with the allowed penetration @p delta.
    void begin_increment(double time, double delta);

    /// Edges that may have contact at @p q plus @p step, if there is one, in which the tool goes on from @p way by @p
    /// motion, are no longer far, and their increment begins. @return these edges
    std::vector<unsigned int>
    approach(const Vector &q, const Vector *step, const Tensor1 &way, const Tensor1 &motion);

    /// Remember the trial points, and go back to them.
    ///@{
    void keep()
    {
      kept_ = trial.points;
    }
    void go_back()
    {
      trial.points = kept_;
    }
    ///@}

    /// The trial state becomes the committed one, at @p q with the tool at @p way. These edges are far from here on; if
    /// no point touches, none are.
    void accept(const Vector &q, const Tensor1 &way, const std::vector<EdgeClearance> &far);

    /// All edges are near, their committed points where they are at the committed @p q.
    void look_at_far(const Vector &q, const Tensor1 &way);

    /// On trial.
    unsigned int n_touching() const;

    /// How far the tool can go before it touches, on trial; 0 if it touches.
    double free_travel() const;

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      const std::size_t n = committed.points.size();
      archive &committed;
      if (committed.points.size() != n)
        throw SceneError("The saved state has another number of contact points: it is damaged. Start again.");
    }

  private:
    /// The trial points of edge @p e begin with the committed ones.
    void begin(unsigned int e);

    /// Put points of edge @p e down where they are at @p q, with the tool at @p way: the committed ones, and those on
    /// trial with their gaps.
    ///@{
    void locate_committed(unsigned int e, const Vector &q, const Tensor1 &way);
    void locate_trial(unsigned int e, const Vector &q, const Tensor1 &way);
    ///@}

    ContactProjector &projector_;
    std::vector<ContactPointState> kept_;
    double delta_ = 0;
  };
} // namespace deltaform
