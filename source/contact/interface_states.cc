#include <deltaform/contact/interface_states.h>

#include <algorithm>

namespace deltaform
{
  void InterfaceStates::resize()
  {
    committed.points.assign(projector_.n_points(), ContactPointState());
    trial.points = committed.points;
  }


  void InterfaceStates::begin_stage(const Vector &q, const double time, const Tensor1 &way)
  {
    committed.time = trial.time = time;
    committed.step = 0.;
    for (unsigned int i = 0; i < committed.points.size(); ++i)
    {
      const ContactPoint description = projector_.point(q, i);
      committed.points[i].position = description.x - way;
      committed.points[i].thickness = description.thickness;
    }
    projector_.look_at_all();
    projector_.discard_distances();
  }


  std::vector<unsigned int> InterfaceStates::look_at_near(const Vector &q, const Tensor1 &way)
  {
    std::vector<unsigned int> edges = projector_.far().begin_increment(projector_, q, way);
    for (const unsigned int e : edges)
      locate_committed(e, q, way);
    return edges;
  }


  std::vector<unsigned int>
  InterfaceStates::approach(const Vector &q, const Vector *const step, const Tensor1 &way, const Tensor1 &motion)
  {
    FarEdges &far = projector_.far();
    std::vector<unsigned int> edges = far.approach(projector_, q, step, way + motion);
    for (const unsigned int e : edges)
      locate_committed(e, far.start(), far.start_shift());
    projector_.find_flat(edges, committed.points, delta_);
    for (const unsigned int e : edges)
    {
      begin(e);
      locate_trial(e, q, way);
    }
    return edges;
  }


  void InterfaceStates::begin_increment(const double time, const double delta)
  {
    delta_ = delta;
    trial.time = time;
    trial.step = committed.step;
    trial.energy = committed.energy;
    projector_.begin_increment(committed.points, delta);
    for (const unsigned int e : projector_.near_edges())
      begin(e);
  }


  void InterfaceStates::begin(const unsigned int e)
  {
    const unsigned int n = projector_.group();
    for (unsigned int i = e * n; i < (e + 1) * n; ++i)
    {
      ContactPointState &state = trial.points[i];
      state = committed.points[i];
      state.delta = delta_;
      state.multiplier = state.touching ? state.force : 0.;
    }
  }


  void InterfaceStates::accept(const Vector &q, const Tensor1 &way, const std::vector<EdgeClearance> &far)
  {
    committed.time = trial.time;
    committed.step = trial.step;
    committed.energy = trial.energy;
    projector_.for_near_points([&](const unsigned int i) { committed.points[i] = trial.points[i]; });
    projector_.leave(far);
    if (n_touching() == 0)
      look_at_far(q, way);
  }


  void InterfaceStates::locate_committed(const unsigned int e, const Vector &q, const Tensor1 &way)
  {
    const unsigned int n = projector_.group();
    ContactPoint point;
    for (unsigned int i = e * n; i < (e + 1) * n; ++i)
    {
      projector_.locate(q, i, point);
      committed.points[i].set_place(point, way);
    }
  }


  void InterfaceStates::locate_trial(const unsigned int e, const Vector &q, const Tensor1 &way)
  {
    const unsigned int n = projector_.group();
    ContactPoint point;
    for (unsigned int i = e * n; i < (e + 1) * n; ++i)
    {
      ContactPointState &state = trial.points[i];
      projector_.locate(q, i, point);
      state.set_place(point, way);
      state.gap = projector_.project(i, state.position).distance - point.offset;
      if (i < kept_.size())
        kept_[i] = state;
    }
  }


  void InterfaceStates::look_at_far(const Vector &q, const Tensor1 &way)
  {
    for (const EdgeClearance &edge : projector_.far().far())
      locate_committed(edge.edge, q, way);
    projector_.look_at_all();
  }


  unsigned int InterfaceStates::n_touching() const
  {
    unsigned int count = 0;
    projector_.for_near_points([&](const unsigned int i) { count += trial.points[i].touching; });
    return count;
  }


  double InterfaceStates::free_travel() const
  {
    if (n_touching() > 0)
      return 0.;
    double closest = projector_.far().least_clearance();
    projector_.for_near_points([&](const unsigned int i) {
      // A node on the axis has no area and no contact. Half of delta beyond the gap: only a penetration makes contact.
      if (const ContactPointState &point = trial.points[i]; point.area > 0)
        closest = std::min(closest, std::max(point.gap, 0.) + .5 * point.delta);
    });
    return closest;
  }
} // namespace deltaform
