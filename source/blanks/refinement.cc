#include <deltaform/blanks/refinement.h>
#include <deltaform/parameters/section.h>

namespace deltaform
{
  RefinementSettings::RefinementSettings(Section section)
  {
    const std::string criterion =
      section.choice("Criterion",
                     "none",
                     {"none", "contact", "recovery"},
                     "Which cells of a solid are refined during the run. contact: those whose contact edges are too "
                     "long for the radius of the tool. recovery: besides, those whose stresses differ most from "
                     "recovered ones (Zienkiewicz and Zhu).");
    active = criterion != "none";
    by_error = criterion == "recovery";
    if (!active && !section.documentation())
      return;
    share = section.number("Error share",
                           .5,
                           Range::above_to(0, 1),
                           "1",
                           "The cells with the largest errors that together hold this share of the squared error are "
                           "refined (Criterion = recovery).");
    target = section.number("Target error",
                            0.,
                            Range::from_to_below(0, 1),
                            "1",
                            "Estimated relative error in energy below which the error refines no further.");
    every = section.integer("Every", 1, 1, 1000000, "Number of increments between refinements.");
    passes = section.integer("Passes", 1, 1, 30,
                             "Largest number of refinements at one time, each followed by a new equilibrium.");
    levels = section.integer("Maximal level", 3, 1, 20, "How many times a cell of the first mesh may be halved.");
    edge_share =
      section.number("Contact edges",
                     .1,
                     Range::not_negative(),
                     "1",
                     "Longest allowed edge that touches, or is about to touch, a round part of a tool, in radii of the "
                     "tool there; 0: any length.");
    rim = section.flag("Contact rim", false, "Refine also where contact ends, up to the maximal level.");
  }
} // namespace deltaform
