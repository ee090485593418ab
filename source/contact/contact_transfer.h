#pragma once

#include <deltaform/assembly/assembly_target.h>
#include <deltaform/assembly/point_origin.h>
#include <deltaform/contact/contact_point_state.h>
#include <deltaform/contact/contact_projector.h>

#include <vector>

namespace deltaform
{
  /**
   * The blank was refined: states of its new contact points. Forces and factors are taken over per area, penetrations
   * and slip as they are, from the two @p old points that @p origins names if both touch, else from the nearer one.
   * Halves of a flat edge (FlatEdges) are flat. The search of @p projector goes on from there.
   * @param shift way of the tool
   */
  std::vector<ContactPointState> transferred_points(const std::vector<ContactPointState> &old,
                                                    std::vector<PointOrigin> origins,
                                                    const Tensor1 &shift,
                                                    const Vector &q,
                                                    ContactProjector &projector);

  /// Forces of touching points at the accepted @p q go to @p target, and none touches from here on.
  void release_points(std::vector<ContactPointState> &points,
                      const Vector &q,
                      const ContactProjector &projector,
                      AssemblyTarget &target);
} // namespace deltaform
