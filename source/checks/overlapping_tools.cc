#include <deltaform/checks/overlapping_tools.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// How deep a point of one tool is inside another.
    struct Overlap
    {
      double depth = 0.; ///< 0: nowhere
      Point2 where;
    };

    /// Where the blank may be between two tools.
    struct Reach
    {
      double first_r, last_r;
      double size; ///< of blank and tools
      double chord;
    };

    /// Points of a tool's outline, corners included, at most a chord apart within the reach.
    std::vector<Point2> outline(const Tool &tool, const double travel, const Reach &reach)
    {
      const auto corners = tool.polyline(travel, reach.size, true);
      std::vector<Point2> points;
      for (unsigned int i = 0; i + 1 < corners.size(); ++i)
      {
        const Tensor1 edge = corners[i + 1] - corners[i];
        const auto n = std::clamp(static_cast<unsigned int>(std::ceil(edge.norm() / reach.chord)), 1u, 400u);
        for (unsigned int k = 0; k < n; ++k)
          points.push_back(corners[i] + (k / static_cast<double>(n)) * edge);
      }
      if (!corners.empty())
        points.push_back(corners.back());
      return points;
    }

    /// The point of @p one that is deepest inside @p other.
    void
    add(const Tool &one, const double travel, const Tool &other, const double at, const Reach &reach, Overlap &overlap)
    {
      for (const Point2 &x : outline(one, travel, reach))
        if (x[0] >= reach.first_r && x[0] <= reach.last_r)
          if (const double distance = other.project(x, at).distance; - distance > overlap.depth)
            overlap = {-distance, x};
    }

    Reach reach_of(const Actors &actors)
    {
      const double h = actors.blank->initial_thickness();
      Reach reach{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0., 0.};
      for (const auto &x : actors.blank->positions(Vector(actors.blank->n_dofs())))
      {
        reach.first_r = std::min(reach.first_r, x[0]);
        reach.last_r = std::max(reach.last_r, x[0]);
        reach.size = std::max(reach.size, x.norm());
      }
      // Solids grow by about their height. What begins at r = 0 is half of a body that is alike on the other side.
      reach.last_r += h;
      if (reach.first_r != 0.)
        reach.first_r -= h;
      reach.chord = std::max(.25 * h, .002 * reach.size);
      for (const auto &tool : actors.tools)
        for (const Point2 &x : tool->polyline(tool->travel(0.)))
          reach.size = std::max(reach.size, x.norm());
      return reach;
    }

    /// Does the stage end as soon as the gap between two tools is as small as is asked for?
    bool ends_by_gap(const Tool &a, const Tool &b, const Stage &stage)
    {
      const std::string one = text::column_name(a.name()), other = text::column_name(b.name());
      const auto conditions = text::split(stage.ends_when, ';');
      return std::any_of(conditions.begin(), conditions.end(), [&](const std::string &condition) {
        const auto parts = text::split(condition, '<');
        return parts.size() == 2 &&
               (parts[0] == one + "_to_" + other + "_gap" || parts[0] == other + "_to_" + one + "_gap");
      });
    }

    bool may_clash(const Tool &a, const Tool &b, const Stage &stage)
    {
      return a.side() != b.side() && !a.force_driven() && !b.force_driven() && a.exists_in(stage.name) &&
             b.exists_in(stage.name) && !ends_by_gap(a, b, stage);
    }

    /// How deep two tools overlap at a time.
    Overlap overlap_at(const Tool &a, const Tool &b, const double time, const Reach &reach)
    {
      const double travel_a = a.travel(time), travel_b = b.travel(time);
      Overlap overlap;
      add(a, travel_a, b, travel_b, reach, overlap);
      add(b, travel_b, a, travel_a, reach, overlap);
      return overlap;
    }

    /// The first of the sampled times at which two tools overlap by more than the tolerance, and where.
    std::pair<double, Overlap>
    first_overlap(const Tool &a, const Tool &b, const Stage &stage, const Reach &reach, const double tolerance)
    {
      constexpr unsigned int n_times = 50;
      std::vector<double> times, ways;
      for (unsigned int k = 0; k <= n_times; ++k)
      {
        times.push_back(stage.begin + (stage.end - stage.begin) * k / n_times);
        const Tensor1 way = a.travel(times[k]) * a.direction() - b.travel(times[k]) * b.direction();
        ways.push_back(way * a.direction());
      }
      // Tools have no back: on one line, what overlaps at all does so where they have come closest to each other.
      const bool on_one_line = std::abs(std::abs(a.direction() * b.direction()) - 1.) < 1e-12;
      const auto range = std::minmax_element(ways.begin(), ways.end());
      const auto free_at = [&](const auto place) {
        return overlap_at(a, b, times[static_cast<std::size_t>(place - ways.begin())], reach).depth <= tolerance;
      };
      if (on_one_line && free_at(range.first) && (*range.first == *range.second || free_at(range.second)))
        return {};
      for (const double time : times)
        if (const Overlap overlap = overlap_at(a, b, time, reach); overlap.depth > tolerance)
          return {time, overlap};
      return {};
    }
  } // namespace


  std::vector<std::string> overlapping_tools(const Actors &actors)
  {
    std::vector<std::string> sentences;
    if (actors.tools.size() < 2)
      return sentences;
    const Reach reach = reach_of(actors);
    const double tolerance = .01 * actors.blank->typical_length();
    for (unsigned int i = 0; i < actors.tools.size(); ++i)
      for (unsigned int j = i + 1; j < actors.tools.size(); ++j)
        for (const auto &stage : actors.stages)
        {
          const Tool &a = *actors.tools[i], &b = *actors.tools[j];
          if (!may_clash(a, b, stage))
            continue;
          const auto [time, overlap] = first_overlap(a, b, stage, reach, tolerance);
          if (overlap.depth > tolerance)
            sentences.push_back("tools '" + a.name() + "' and '" + b.name() + "' overlap in stage '" + stage.name +
                                "' from time " + text::format(time) + " on, at r = " + text::rounded(overlap.where[0]) +
                                ", z = " + text::rounded(overlap.where[1]) + " by " + text::rounded(overlap.depth) +
                                ": the blank has no room between them. Shorten the Motion of one, move it back, or "
                                "give it a Force");
        }
    return sentences;
  }
} // namespace deltaform
