#pragma once

#include <deltaform/assembly/side.h>
#include <deltaform/contact/contact_interface.h>

#include <vector>

namespace deltaform
{
  /// Contact pressure of the @p n_nodes nodes of the blank: of the points that a node carries the forces by @p points,
  /// accepted or trial ones, over the tributary areas at @p q (stress). At other nodes 0.
  std::vector<double> contact_pressure(const ContactInterface &contact,
                                       const std::vector<ContactPointState> &points,
                                       const Vector &q,
                                       std::size_t n_nodes);

  /// Add it to the pressure on the side of the blank that the tool touches.
  void add_contact_pressure(const ContactInterface &contact,
                            const std::vector<ContactPointState> &points,
                            const Vector &q,
                            FaceValues &pressure);

  /// No nodal pressure has changed by more from the accepted to the trial points (stress).
  double largest_pressure_change(const ContactInterface &contact);

  /// Estimate of the discretisation error in the contact surface, as an allowed penetration (doc/theory/contact.md).
  double automatic_delta(const ContactInterface &contact);

  /// How far the face of the blank is from the contact point, with the thickness compressed by its force (length).
  inline double face(const ContactPoint &node, const ContactPointState &state)
  {
    return node.offset - (state.touching ? node.compliance * state.force : 0.);
  }

  /// Where contact wants short edges.
  struct EdgeWishes
  {
    double share = 0.; ///< of the radius of the tool that an edge touches or is about to touch; 0: any length
    bool at_rim = false; ///< where contact ends inside the edge, as short as possible
    bool smooth = false; ///< do edges make up a smooth curve? It goes around a sharp corner in a radius of its own
    std::vector<double> lengths = {}; ///< of the edges now, if known: those that are short enough for every radius of
      ///< the tool are not looked at
    std::vector<bool> clamped = {}; ///< edges that a tool at a gap holds from the other side, if any (clamp_edges()):
      ///< they cannot give way as a long one has to that comes to a radius (doc/theory/shell.md)
  };

  /// Set the edges that the tool touches, and the next ones on either side.
  void clamp_edges(const ContactInterface &contact, std::vector<bool> &clamped);

  /// Lower the longest allowed undeformed length of each edge of the side where it touches, or is about to touch, a
  /// round part of the tool, so that its present length is a share of the radius at most: of that at the middle of a
  /// sheet. To 0 where no point of a straight edge has noticed the tool, or a sharp corner, yet. @p q: committed
  void shorten_edges(
    const ContactInterface &contact, const Vector &q, const EdgeWishes &wishes, std::vector<double> &longest);
} // namespace deltaform
