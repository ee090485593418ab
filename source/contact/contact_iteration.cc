#include <deltaform/contact/contact_iteration.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <limits>

namespace deltaform
{
  ContactIteration::ContactIteration(const NormalLaw &law,
                                     ContactProjector &projector,
                                     const FactorControl &factors,
                                     InterfaceFriction *friction)
    : law_(law), projector_(projector), factors_(factors), friction_(friction),
      points_(law, projector, factors, friction), clear_(projector)
  {
  }


  void ContactIteration::resize(const unsigned int n_points)
  {
    points_.resize(n_points);
    group_ = projector_.group();
    if (friction_ != nullptr)
      friction_->resize(n_points);
    every_point_ = law_.has_multiplier() || group_ < 3;
    edges_.assign(group_ > 1 ? n_points / group_ : 0, Edge());
  }


  void ContactIteration::restart(const bool at_start)
  {
    points_.restart(at_start);
    discard_rows();
    clear_.restart(!law_.has_multiplier());
  }


  void ContactIteration::discard_rows()
  {
    if (!edges_.empty())
      for (const unsigned int e : projector_.near_edges())
        edges_[e].known = false;
  }


  void ContactIteration::renew(const unsigned int e)
  {
    look_again(e);
    edges_[e].touching = 0;
    for (unsigned int i = e * group_; i < (e + 1) * group_; ++i)
      points_.renew(i);
  }


  template <typename Action>
  void ContactIteration::for_points(const unsigned int e, const Action &action) const
  {
    const unsigned int step = stride(e);
    for (unsigned int i = e * group_; i < (e + 1) * group_; i += step)
      action(i);
  }


  template <typename Action>
  void ContactIteration::for_points(const Action &action) const
  {
    for (const unsigned int e : projector_.near_edges())
      if (!clear_.known(e))
        for_points(e, action);
  }


  void ContactIteration::assemble(const Vector &q,
                                  const Tensor1 &shift,
                                  const double time,
                                  const Points &committed,
                                  Points &trial,
                                  AssemblyTarget &target)
  {
    points_.begin_assembly();
    projector_.counterpart().add_load(q, time, target);
    if (!points_.in_place())
      projector_.moving().follow(projector_, q, shift, points_.at_start(), trial);
    if (edges_.empty())
      for (unsigned int i = 0; i < trial.size(); ++i)
      {
        points_.press(i, q, shift, committed, trial);
        points_.add(i, q, committed, trial, target);
      }
    tool_force_ = points_.take_force();
    if (edges_.empty())
      return;
    for (const unsigned int e : projector_.near_edges())
    {
      Edge &edge = edges_[e];
      edge.known &= points_.in_place() && edge.rows.wants_tangent() == target.wants_tangent();
      // In place foresee() has looked at the clear ones.
      if (points_.in_place() ? clear_.known(e) : clear_.clear(e, q, nullptr, shift))
        continue;
      if (!edge.known)
      {
        assemble_edge(e, q, shift, committed, trial, target.wants_tangent());
        find_clear(e, q, shift, trial);
      }
      edge.rows.add_to(target);
      tool_force_ += edge.tool_force;
    }
  }


  void ContactIteration::assemble_edge(const unsigned int e,
                                       const Vector &q,
                                       const Tensor1 &shift,
                                       const Points &committed,
                                       Points &trial,
                                       const bool tangent)
  {
    Edge &edge = edges_[e];
    edge.rows.begin(tangent);
    edge.touching = 0;
    for_points(e, [&](const unsigned int i) {
      points_.press(i, q, shift, committed, trial);
      if (trial[i].touching)
        boost::hash_combine(edge.touching, i);
    });
    const bool shared = friction_ != nullptr && friction_->shares();
    if (shared)
    {
      friction_->look_at(e, trial, stride(e));
      points_.begin_edge();
    }
    for_points(e, [&](const unsigned int i) { points_.add(i, q, committed, trial, edge.rows); });
    if (shared)
      points_.end_edge(edge.rows);
    edge.tool_force = points_.take_force();
    edge.known = true;
  }


  void ContactIteration::find_clear(const unsigned int e, const Vector &q, const Tensor1 &shift, const Points &trial)
  {
    if (!clear_.used())
      return;
    double clearance = std::numeric_limits<double>::infinity(), offset = 0.;
    for_points(e, [&](const unsigned int i) {
      clearance = std::min(clearance, points_.clear_way(i, trial[i]));
      offset = std::max(offset, points_.point(i).offset);
    });
    points_.find_row(e * group_, q);
    clear_.set(e, q, shift, points_.point(e * group_), clearance, offset);
  }


  void ContactIteration::locate(const unsigned int first,
                                const unsigned int end,
                                const Vector &q,
                                const Tensor1 &shift,
                                Points &trial) const
  {
    ContactPoint point;
    for (unsigned int i = first; i < end; ++i)
    {
      projector_.locate(q, i, point);
      trial[i].set_place(point, shift);
    }
  }


  bool
  ContactIteration::is_far(const unsigned int e, const Vector &q, const Tensor1 &shift, const Points &committed) const
  {
    const auto first = committed.begin() + e * group_;
    return projector_.far().is_far(projector_, clear_.of(e), q, shift) &&
           std::none_of(first, first + group_, [](const ContactPointState &state) { return state.touching; });
  }


  std::vector<EdgeClearance>
  ContactIteration::complete(const Vector &q, const Tensor1 &shift, const Points &committed, Points &trial)
  {
    std::vector<EdgeClearance> far;
    const unsigned int n = group_;
    if (edges_.empty())
      return far;
    const std::vector<unsigned int> &near = projector_.near_edges();
    // A tool that touches nowhere asks all points for the way that it has.
    const bool touches =
      std::any_of(near.begin(), near.end(), [&](const unsigned int e) { return edges_[e].touching != 0; });
    for (const unsigned int e : near)
      if (!clear_.known(e))
      {
        if (stride(e) > 1)
          locate(e * n + 1, (e + 1) * n - 1, q, shift, trial);
      }
      else if (touches && is_far(e, q, shift, committed))
        far.push_back(clear_.of(e));
      else
        locate(e * n, (e + 1) * n, q, shift, trial);
    return far;
  }


  void ContactIteration::complete_flat(const Vector &q, const Tensor1 &shift, Points &trial)
  {
    const unsigned int n = group_;
    if (edges_.empty())
      return;
    for (const unsigned int e : projector_.near_edges())
      if (stride(e) > 1 && edges_[e].touching != 0)
        locate(e * n + 1, (e + 1) * n - 1, q, shift, trial);
  }


  bool ContactIteration::foresee(const Vector &q, const Tensor1 &shift, const Vector &d, const Points &trial)
  {
    bool other = false;
    points_.stay_in_place();
    const Tensor1 end = shift + projector_.counterpart().motion(d);
    for (const unsigned int e : projector_.near_edges())
    {
      if (clear_.clear(e, q, &d, end))
        continue;
      bool own = false;
      for_points(e, [&](const unsigned int i) {
        if (clear_.known(e))
          points_.describe(i, q);
        own |= points_.foresee(i, q, d, trial[i]);
      });
      if (own)
        look_again(e);
      other |= own;
    }
    return other;
  }


  void ContactIteration::peel(const unsigned int reach, const Points &trial)
  {
    std::vector<unsigned int> released;
    for_points([&](const unsigned int i) {
      if (points_.is_released(i, trial[i]))
        released.push_back(i);
    });
    const unsigned int way = reach * group_;
    for (const unsigned int i : released)
      for (unsigned int k = i - std::min(i, way); k <= i + way && k < trial.size(); ++k)
        if (points_.release(k))
          look_again(k / group_);
  }


  void ContactIteration::prepare_step(const Vector &d, const Points &committed, const Points &trial)
  {
    points_.leave_start();
    for_points([&](const unsigned int i) { points_.prepare_step(i, d, committed[i], trial[i]); });
  }


  void ContactIteration::advance(const double factor, Points &trial)
  {
    points_.leave_place();
    for_points([&](const unsigned int i) { points_.advance(i, factor, trial[i]); });
  }


  unsigned int ContactIteration::correct_early(Points &trial)
  {
    std::vector<unsigned int> touching;
    for (const unsigned int e : projector_.near_edges())
      if (edges_.empty() || edges_[e].touching != 0)
        for (unsigned int i = e * group_; i < (e + 1) * group_; ++i)
          if (trial[i].touching)
            touching.push_back(i);
    const unsigned int changed = factors_.correct_early(touching, trial);
    if (changed > 0)
      discard_rows();
    return changed;
  }


  std::size_t ContactIteration::signature(const Points &trial) const
  {
    std::size_t result = 0;
    if (edges_.empty())
    {
      for (const auto &state : trial)
        boost::hash_combine(result, state.touching);
      return result;
    }
    for (const unsigned int e : projector_.near_edges())
      if (edges_[e].touching != 0)
      {
        boost::hash_combine(result, e);
        boost::hash_combine(result, edges_[e].touching);
      }
    return result;
  }
} // namespace deltaform
