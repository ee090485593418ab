#include "solid_discretization.h"

#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/ranks.h>

namespace deltaform
{
  void SolidDiscretization::set_up(const SolidSpace::CellPlaces &places)
  {
    space_.set_up(places);
    points_.set_up();
    boundary_.set_up();
  }


  void SolidDiscretization::check(const Section &section) const
  {
    for (const auto &X : space_.nodes())
      if (space_.axisymmetric() && X[0] < -1e-9 * space_.mesh().thickness())
        section.fail("Symmetry",
                     "an axisymmetric body must lie at r >= 0: a node is at r = " + text::format(X[0]) +
                       ", z = " + text::format(X[1]));
    std::vector<unsigned int> bad; // a node of the first bad cell of each process
    for (unsigned int p = 0; p < points_.size() && bad.empty(); ++p)
      if (!(points_[p].weight > 0))
        bad.push_back(space_.cells()[p / points_.per_cell()][0]);
    for (const auto node : ranks::gather(bad))
      section.fail(
        space_.mesh().is_strip() ? "Thickness" : "File",
        "the cell near r = " + text::format(space_.nodes()[node][0]) +
          ", z = " + text::format(space_.nodes()[node][1]) +
          " is turned inside out: the strip is thicker than its meridian is curved, or the mesh is clockwise");
  }
} // namespace deltaform
