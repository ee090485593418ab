#include "contact_transfer.h"

#include <algorithm>
#include <utility>

namespace deltaform
{
  namespace
  {
    /// What a new point takes over that lies a @p share of the way from one old point to another, which both touch.
    /// What belongs to an area is interpolated per area, the rest as it is; forces and factors are those of @p area.
    ContactPointState
    between(const ContactPointState &a, const ContactPointState &b, const double share, const double area)
    {
      const auto mean = [&](const auto member) { return (1. - share) * a.*member + share * b.*member; };
      const auto by_area = [&](const auto member) {
        double sum = 0., weights = 0.;
        for (const auto &[point, weight] : {std::pair(&a, 1. - share), std::pair(&b, share)})
          if (point->area > 0)
          {
            sum += weight * point->*member / point->area;
            weights += weight;
          }
        return weights > 0 ? sum / weights * area : 0.;
      };
      using State = ContactPointState;
      State state = share > .5 ? b : a;
      state.sticking = a.sticking && b.sticking;
      for (const auto member : {&State::force,
                                &State::previous_force,
                                &State::multiplier,
                                &State::penalty_factor,
                                &State::shift,
                                &State::stiffness,
                                &State::tangential_force,
                                &State::tangential_factor})
        state.*member = by_area(member);
      for (const auto member : {&State::gap, &State::last_penetration, &State::delta, &State::slip_start, &State::slip})
        state.*member = mean(member);
      return state;
    }


    /// The state of a new point without its place.
    ContactPointState
    inherited(const std::vector<ContactPointState> &old, const PointOrigin &origin, const double area)
    {
      if (!(area > 0))
        return {};
      const ContactPointState &a = old[origin.first], &b = old[origin.second];
      if (a.touching && b.touching)
        return between(a, b, origin.share, area);
      if (origin.share == .5)
        return {};
      const ContactPointState &nearer = origin.share > .5 ? b : a;
      return nearer.touching ? between(nearer, nearer, 0., area) : ContactPointState();
    }


    /// Nodes without area (axis) have nothing to leave: their neighbour stands for them.
    void leave_out_weightless_nodes(const std::vector<ContactPointState> &old, std::vector<PointOrigin> &origins)
    {
      for (auto &[a, b, share] : origins)
        if (!(old[a].area > 0))
          a = b;
        else if (!(old[b].area > 0))
          b = a;
    }


    /// Points of a flat edge between its outermost ones know nothing: these stand for them. @return the edges of the
    /// new mesh that lie in flat ones
    std::vector<bool> leave_out_flat_edges(const std::vector<ContactPointState> &old,
                                           const unsigned int per_edge,
                                           std::vector<PointOrigin> &origins,
                                           const std::vector<Point2> &places)
    {
      const std::vector<bool> flat = FlatEdges::were_flat(old, per_edge);
      const auto outermost = [&](const unsigned int point, const bool first) {
        const unsigned int e = point / per_edge;
        return flat[e] ? e * per_edge + (first ? 0 : per_edge - 1) : point;
      };
      std::vector<bool> result(origins.size() / per_edge);
      for (unsigned int e = 0; e < result.size(); ++e)
      {
        const PointOrigin &middle = origins[e * per_edge + per_edge / 2];
        result[e] = flat[middle.first / per_edge] && flat[middle.second / per_edge];
      }
      for (unsigned int i = 0; i < origins.size(); ++i)
      {
        auto &[a, b, share] = origins[i];
        if (a / per_edge != b / per_edge || !flat[a / per_edge])
          continue;
        a = outermost(a, true);
        b = outermost(b, false);
        const Tensor1 along = old[b].position - old[a].position;
        share = std::clamp(((places[i] - old[a].position) * along) / along.norm_square(), 0., 1.);
      }
      return result;
    }
  } // namespace


  std::vector<ContactPointState> transferred_points(const std::vector<ContactPointState> &old,
                                                    std::vector<PointOrigin> origins,
                                                    const Tensor1 &shift,
                                                    const Vector &q,
                                                    ContactProjector &projector)
  {
    std::vector<bool> flat;
    if (projector.surface().points_per_edge() == 0)
      leave_out_weightless_nodes(old, origins);
    else
    {
      std::vector<Point2> places;
      for (unsigned int i = 0; i < origins.size(); ++i)
        places.push_back(projector.point(q, i).x - shift);
      flat = leave_out_flat_edges(old, projector.group(), origins, places);
    }
    projector.renumber(origins, flat);

    std::vector<ContactPointState> points(projector.n_points());
    for (unsigned int i = 0; i < origins.size(); ++i)
    {
      const ContactPoint description = projector.point(q, i);
      ContactPointState &state = points[i];
      state = inherited(old, origins[i], description.area);
      state.position = description.x - shift;
      state.area = description.area;
      state.thickness = description.thickness;
      state.compliance = description.compliance;
      if (state.touching)
        state.arc_length = projector.look(i, state.position).arc_length;
    }
    return points;
  }


  void release_points(std::vector<ContactPointState> &points,
                      const Vector &q,
                      const ContactProjector &projector,
                      AssemblyTarget &target)
  {
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      ContactPointState &state = points[i];
      if (state.touching)
      {
        const ContactPoint description = projector.point(q, i);
        target.add(description.dofs.data(), description.n_dofs, nullptr, state.residual.data());
      }
      state.release();
    }
  }
} // namespace deltaform
