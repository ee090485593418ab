#pragma once

#include <deltaform/contact/contact_interface.h>

namespace deltaform
{
  /// A place of the face of the blank, and how deep in the tool it is (length; 0 where it is not).
  struct DeepestPlace
  {
    double depth = 0.;
    Point2 place;
  };

  /// The deepest place of a face, and that of the edges that do not bend over a sharp convex corner of the tool, which
  /// no mesh can follow.
  struct DeepestPlaces
  {
    DeepestPlace anywhere, off_corners;
  };

  /// Where the accepted contact penetrates most: along all edges that have a touching point, not only at these
  /// points.
  DeepestPlaces deepest_places(const ContactInterface &contact, const Vector &q);

  /// Largest penetration of the accepted contact anywhere along the edges (length).
  inline double penetration_between_nodes(const ContactInterface &contact, const Vector &q)
  {
    return deepest_places(contact, q).anywhere.depth;
  }
} // namespace deltaform
