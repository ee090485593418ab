#pragma once

#include <deltaform/stage/contact_set.h>

namespace deltaform
{
  /// What is reported of contact in an accepted state, over all tools.
  struct ContactAccount
  {
    unsigned int n_touching = 0; ///< a point between two tools counts twice
    double max_penetration = 0, max_penetration_over_delta = 0, max_penetration_between_nodes = 0;
    double min_epsilon = 0, max_epsilon = 0; ///< penalty factors of what touches
    double floor_share = 0; ///< of what touches: penalty factor at its lower bound

    /// The deepest place of the face in a tool, in units of delta; not where an edge bends over a sharp corner.
    struct Deepest
    {
      double over_delta = 0, depth = 0;
      Point2 place;
      unsigned int tool = invalid_index;
    } deepest;
  };

  /// Of the committed state @p q of a stage.
  ContactAccount contact_account(const ContactSet &contact, const Actors &actors, const Vector &q);
} // namespace deltaform
