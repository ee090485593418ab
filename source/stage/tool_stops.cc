#include <deltaform/stage/tool_stops.h>
#include <deltaform/tools/tool_gap.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  Status ToolStops::assemble(const Vector &q, const double time, AssemblyTarget &target) const
  {
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
    {
      const Tool &tool = *actors_.tools[i];
      if (!tool.force_driven() || !tool.exists_in(stage_))
        continue;
      const DofIndex dof = actors_.interfaces[i]->travel_dof();
      const double beyond = overrun(i, q[dof], time);
      if (!(beyond > 0.))
        continue;
      const TimeFunction *const own = tool.allowed_penetration();
      const double delta = own != nullptr ? (*own)(time) : actors_.contact->allowed_penetration(time);
      const double smallest = 1e-3 * actors_.blank->typical_length();
      const double least_force = 1e-6 * actors_.blank->stiffness_scale() * smallest;
      const double stiffness = std::max(tool.force(time), least_force) / (delta > 0. ? delta : smallest);
      const double force = stiffness * beyond;
      target.add(&dof, 1, target.wants_tangent() ? &stiffness : nullptr, &force);
    }
    return {};
  }


  double ToolStops::overrun(const unsigned int i, const double travel, const double time) const
  {
    const Tool &tool = *actors_.tools[i];
    const double beyond_place = std::max(travel - tool.stop_travel(time), 0.);
    // A gap changes by no more than the travel.
    Clearance &known = known_[i];
    if (known.time == time && travel - known.travel < known.gap)
      return beyond_place;
    double reach = 0.;
    for (const auto &x : actors_.blank->positions(Vector(actors_.blank->n_dofs())))
      reach = std::max(reach, 1.5 * x.norm());
    known = {time, travel, clearance(tool, travel, time, reach)};
    if (known.gap >= 0.)
      return beyond_place;
    // Back to where it is clear, and from there on by the gap, which never goes too far.
    const double length = actors_.blank->typical_length();
    constexpr unsigned int most_steps = 200;
    double stop = travel;
    unsigned int step = 0;
    for (; step < most_steps && known.gap < 0.; ++step)
    {
      stop -= length - known.gap;
      known = {time, stop, clearance(tool, stop, time, reach)};
    }
    for (; step < most_steps && known.gap > 1e-9 * length && stop < travel; ++step)
    {
      stop += known.gap;
      known = {time, stop, clearance(tool, stop, time, reach)};
    }
    return std::max(beyond_place, std::max(travel - stop, 0.));
  }


  double ToolStops::clearance(const Tool &tool, const double travel, const double time, const double reach) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto &other : actors_.tools)
      if (other->side() != tool.side() && other->exists_in(stage_) && !other->force_driven())
        least = std::min(least, tool_gap(tool, travel, *other, other->travel(time), reach));
    return least - tool.stop_gap();
  }
} // namespace deltaform
