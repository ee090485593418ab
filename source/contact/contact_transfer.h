#pragma once

#include <deltaform/contact/contact_point_state.h>
#include <deltaform/contact/contact_projector.h>

#include <array>
#include <vector>

namespace deltaform
{
  /**
   * The blank was refined: states of its new contact points. Forces and factors are taken over per area, penetrations
   * and slip as they are, from the two @p old points that @p parents names, if both touch. The search of @p projector
   * goes on from there.
   * @param shift way of the tool
   */
  std::vector<ContactPointState> transferred_points(const std::vector<ContactPointState> &old,
                                                    std::vector<std::array<unsigned int, 2>> parents,
                                                    const Tensor1 &shift,
                                                    const Vector &q,
                                                    ContactProjector &projector);
} // namespace deltaform
