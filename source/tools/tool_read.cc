#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>
#include <deltaform/tools/tool.h>

#include <cmath>
#include <stdexcept>

// The tool's section of the scene.

namespace deltaform
{
  namespace
  {
    // A choice that has no default. Asked for before it is declared: the message then speaks of no default.
    void require(const Section &section, const std::string &entry, const std::string &choices)
    {
      if (!section.given(entry) && !section.documentation())
        section.fail(entry, "is required: " + choices);
    }

    double read_coordinate(Section &section,
                           const std::string &entry,
                           const Default<std::string> &value,
                           const std::string &sentence,
                           const std::map<std::string, double> &constants)
    {
      const TimeFunction coordinate = section.function(entry, value, "length", sentence, constants);
      if (!coordinate.is_constant())
        section.fail(entry, "A position does not depend on t: use Motion.");
      return coordinate(0.);
    }

    // A function that may be left out: empty text.
    std::optional<TimeFunction> read_optional(Section &section,
                                              const std::string &entry,
                                              const std::string &sentence,
                                              const std::map<std::string, double> &constants)
    {
      const std::string text = section.text(entry, std::string(), sentence);
      if (text.empty())
        return std::nullopt;
      try
      {
        return TimeFunction(text, constants);
      }
      catch (const std::invalid_argument &error)
      {
        section.fail(entry, error.what());
      }
    }

    Tensor1 read_direction(Section &section, const Side side)
    {
      const auto rows = section.rows("Direction",
                                     std::string(side == Side::top ? "0 -1" : "0 1"),
                                     2,
                                     "1",
                                     "Direction r z of travel and force; by default against the blank, so 0 -1 for a "
                                     "tool on the top and 0 1 for one at the bottom. Its length does not matter.");
      if (rows.size() != 1)
        section.fail("Direction", "A direction has two components.");
      Tensor1 direction;
      direction[0] = rows[0][0];
      direction[1] = rows[0][1];
      const double length = direction.norm();
      if (!(length > 0.) || !std::isfinite(length))
        section.fail("Direction", "The direction must not be zero.");
      direction[0] /= length; // deal.II's division multiplies by the inverse, and (0, -1) must stay exactly that
      direction[1] /= length;
      return direction;
    }
  } // namespace


  Tool::Tool(const std::string &name,
             Section section,
             const std::map<std::string, double> &constants,
             const std::map<std::string, double> &penetration_constants,
             const bool axisymmetric)
    : name_(name)
  {
    require(section, "Side", "bottom or top, the face of the blank that the tool touches");
    const std::string side =
      section.choice("Side", "bottom", {"bottom", "top"}, "Face of the blank that the tool touches; to be stated.");
    side_ = side == "top" ? Side::top : Side::bottom;
    require(section, "Shape", text::join(Registry<Shape>::names(), ", "));
    shape_ = Registry<Shape>::choose(section, "Shape", "plate", "Profile of the tool; to be stated.");
    if (!axisymmetric)
      shape_->set_plane_strain();
    mirror_ = side_ == Side::top && !shape_->in_scene_frame() ? -1. : 1.;

    position_[0] = read_coordinate(
      section, "Position r", std::string("0"), "Where the origin of the shape is at travel 0.", constants);
    position_[1] = read_coordinate(section,
                                   "Position z",
                                   required(std::string("-thickness/2")),
                                   "Where the origin of the shape is at travel 0; may use the blank's thickness.",
                                   constants);
    direction_ = read_direction(section, side_);

    motion_ = section.function("Motion", std::string("0"), "length", "Travel along the direction.", constants);
    force_ = read_optional(section,
                           "Force",
                           "Force along the direction against the blank (force, function of t) instead of a motion; "
                           "the travel follows from equilibrium. Full circumference, or per unit width.",
                           constants);
    if (force_driven() && section.given("Motion"))
      section.fail("Force", "A tool has either a motion or a force, not both.");

    stop_travel_ = read_optional(section, "Stop travel",
                                 "Travel at which a stop in the press takes the force of a tool under a force (length, "
                                 "may use t and thickness); empty: no stop.",
                                 constants);
    stop_gap_ = section.number("Stop gap", 0., Range::not_negative(), "length",
                               "Smallest gap from a tool under a force to the tools on the other side of the blank. "
                               "It rests there once the blank has left.");
    if (!force_driven() && (stop_travel_ || stop_gap_ > 0.))
      section.fail(stop_travel_ ? "Stop travel" : "Stop gap",
                   "Only a tool that is driven by a Force is stopped; a Motion ends where it says.");

    auto with_auto = penetration_constants;
    with_auto["auto"] = -1.; // see ContactSettings
    allowed_penetration_ =
      read_optional(section,
                    "Allowed penetration",
                    "delta of this tool (length, may use t, thickness and edge, or auto); empty: that of section "
                    "Contact.",
                    with_auto);
    stages_ = section.names("Stages", "", "Stages in which the tool takes part; empty: all.");
  }
} // namespace deltaform
