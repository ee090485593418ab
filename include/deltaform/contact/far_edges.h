#pragma once

#include <deltaform/contact/edge_clearance.h>
#include <deltaform/io/archive.h>
#include <deltaform/parameters/scene_error.h>

#include <limits>
#include <vector>

namespace deltaform
{
  class ContactProjector;

  /**
   * Edges that are so far from the tool that none of their points can touch in the increments to come: nothing is
   * computed of these, and they stay in the state in which they were accepted last. An edge that may have come near
   * has to be looked at again before anybody asks for its points; then the results are the same as if it had never
   * been left alone. All other edges are near.
   */
  class FarEdges
  {
  public:
    /// All of so many edges are near.
    void reset(unsigned int n_edges);

    bool empty() const
    {
      return far_.empty();
    }

    /// Ascending.
    const std::vector<unsigned int> &near() const
    {
      return near_;
    }

    const std::vector<EdgeClearance> &far() const
    {
      return far_;
    }

    /// Where the increment begins.
    ///@{
    const Vector &start() const
    {
      return start_;
    }
    const Tensor1 &start_shift() const
    {
      return start_shift_;
    }
    ///@}

    /// May an edge with this clearance be left alone from here on, at @p q where an increment ends?
    bool
    is_far(const ContactProjector &projector, const EdgeClearance &edge, const Vector &q, const Tensor1 &shift) const;

    /// These near edges are far from here on.
    void add(const std::vector<EdgeClearance> &edges);

    /// An increment begins at the accepted @p q, with the tool at @p shift: edges that are near from here on.
    std::vector<unsigned int> begin_increment(const ContactProjector &projector, const Vector &q, const Tensor1 &shift);

    /// The same at @p q plus @p step, if there is one.
    std::vector<unsigned int>
    approach(const ContactProjector &projector, const Vector &q, const Vector *step, const Tensor1 &shift);

    /// So far any of them may go and stay clear, when they were looked at last; infinite: there is none.
    double least_clearance() const
    {
      return least_clearance_;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive_plain(archive, far_);
      if (!Archive::is_loading::value)
        return;
      if (!take_loaded())
        throw SceneError("The saved state names edges in contact that do not exist: it is damaged. Start again.");
    }

  private:
    /// Edges for which @p is_near(edge, what is left) are near from here on. @return them
    template <typename IsNear>
    std::vector<unsigned int> take(const IsNear &is_near);

    /// Edges and no others, ascending, are far. @return do they exist?
    bool take_loaded();

    void find_near();

    std::vector<EdgeClearance> far_; ///< ascending
    std::vector<unsigned int> near_;
    unsigned int n_edges_ = 0;
    bool dofs_known_ = true; ///< what was loaded may be damaged
    double least_clearance_ = std::numeric_limits<double>::infinity();
    Vector start_;
    Tensor1 start_shift_;
  };
} // namespace deltaform
