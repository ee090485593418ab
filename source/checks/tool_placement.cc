#include <deltaform/checks/tool_placement.h>
#include <deltaform/parameters/text.h>

#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    /// How the material of the blank lies to a tool.
    struct Lie
    {
      double nearest = -std::numeric_limits<double>::infinity(); ///< largest distance of a point that has one
      double deepest = std::numeric_limits<double>::infinity(); ///< smallest one, negative inside the tool
      Point2 where; ///< the deepest point
      double facing = 0.; ///< mean of the normals against the face that the tool touches; negative: away from the blank
    };

    Lie look(const Blank &blank, const Tool &tool, const Vector &q, const double travel)
    {
      Lie lie;
      unsigned int n = 0;
      for (const Point2 &x : blank.positions(q))
      {
        const Projection closest = tool.project(x, travel);
        if (!std::isfinite(closest.distance))
          continue;
        ++n;
        lie.facing += tool.side() == Side::bottom ? closest.normal[1] : -closest.normal[1];
        lie.nearest = std::max(lie.nearest, closest.distance);
        if (closest.distance < lie.deepest)
        {
          lie.deepest = closest.distance;
          lie.where = x;
        }
      }
      lie.facing /= std::max(n, 1u);
      return lie;
    }

    /**
     * A tool walked the other way round has the same closest points, but opposite normals and distances. So all
     * material lies inside, and the normals point away from the face that the tool should touch. (A tool that is only
     * at the wrong place has normals of the right sign; a wall has neither.)
     */
    bool is_walked_backwards(const Lie &lie, const double tolerance)
    {
      return lie.deepest < -tolerance && lie.nearest <= tolerance && lie.facing < .1;
    }

    std::string place(const Point2 &x)
    {
      return "r = " + text::rounded(x[0]) + ", z = " + text::rounded(x[1]);
    }
  } // namespace


  std::optional<Misplacement> find_misplacement(const Blank &blank,
                                                const ContactInterface &interface,
                                                const Vector &q,
                                                const double travel,
                                                const double tolerance)
  {
    const Tool &tool = interface.tool();
    const std::string name = "tool '" + tool.name() + "'";
    if (tool.shape().in_scene_frame())
      if (const Lie lie = look(blank, tool, q, travel); is_walked_backwards(lie, tolerance))
        return Misplacement{"Points",
                            "the profile of " + name +
                              " is walked with the blank to its right, so that the whole blank lies inside the tool "
                              "(deepest at " +
                              place(lie.where) + ", by " + text::rounded(-lie.deepest) +
                              "). Give the points, and their fillet radii, in the opposite order (an outline: Reversed "
                              "= true): walk it with the blank to its left"};

    const auto [node, gap] = interface.projector().closest(q, travel * tool.direction());
    if (!(gap < -tolerance))
      return std::nullopt;
    return Misplacement{"Position z",
                        name + " overlaps the blank: node " + std::to_string(node) + " at " +
                          place(interface.point(q, node).x) + " lies " + text::rounded(-gap) +
                          " inside. Move the tool back by that (Position, or Motion at this time), or let it start "
                          "clear of the blank and approach by Motion"};
  }


  std::string misplaced_tool(const Actors &actors, const std::string &before, const Vector &q, const Stage &next)
  {
    for (const auto &interface : actors.interfaces)
    {
      const Tool &tool = interface->tool();
      if ((!before.empty() && tool.exists_in(before)) || !tool.exists_in(next.name))
        continue;
      // The thickness has changed by forming: a tool that leaves room for the initial one overlaps a little.
      const TimeFunction *own = tool.allowed_penetration();
      const double delta = own ? (*own)(next.begin) : actors.contact->allowed_penetration(next.begin);
      const double tolerance = std::max(.1 * actors.blank->typical_length(), delta);
      const double travel = tool.force_driven() ? q[interface->travel_dof()] : tool.travel(next.begin);
      if (const auto wrong = find_misplacement(*actors.blank, *interface, q, travel, tolerance))
        return wrong->message + " (Tools/" + tool.name() + "/" + wrong->entry + ")";
    }
    return "";
  }
} // namespace deltaform
