#include <deltaform/increment/newton.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  NewtonSettings::NewtonSettings(Section &section)
    : max_iterations(section.integer("Maximal iterations", 20, 2, 1000,
                                     "Largest number of Newton iterations between two corrections of the penalty "
                                     "factors.")),
      max_rounds(
        section.integer("Maximal corrections", 100, 0, 1000,
                        "Largest number of corrections of the penalty factors in an increment.")),
      force_tolerance(
        section.number("Force tolerance",
                       1e-6,
                       Range::inside(0, 1),
                       "1",
                       "Residual over the sum of absolute nodal forces at which equilibrium is accepted.")),
      relaxed_tolerance(
        section.number("Relaxed force tolerance",
                       1e-5,
                       Range::inside(0, 1),
                       "1",
                       "Accepted instead after the maximal number of iterations, where lightly loaded points keep "
                       "changing between contact and no contact.")),
      balance_tolerance(
        section.number("Balance tolerance",
                       5e-4,
                       Range::positive(),
                       "1",
                       "What may be left of the sum of the forces of tools, supports and loads, over the largest of "
                       "them: nodal forces of thin sheets are much larger than those of tools.")),
      displacement_tolerance(
        section.number("Displacement tolerance",
                       1e-3,
                       Range::positive(),
                       "1",
                       "Largest last Newton step, relative to the displacement in the increment (at least 1 % of the "
                       "thickness).")),
      line_search(section.flag("Line search", true, "Search along the Newton step where the residual grows."))
  {
  }
} // namespace deltaform
