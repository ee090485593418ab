#include "shell_transfer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace deltaform
{
  namespace
  {
    Point2 between(const double (&ends)[2][2], const double share)
    {
      return {(1. - share) * ends[0][0] + share * ends[1][0], (1. - share) * ends[0][1] + share * ends[1][1]};
    }

    /// Cubic through the ends with their tangents, and its derivative by the share.
    std::pair<Point2, Tensor1> cubic(const double (&ends)[2][2], const double (&angle)[2], const double t)
    {
      const Point2 a(ends[0][0], ends[0][1]), b(ends[1][0], ends[1][1]);
      // As ShellMeridian has it.
      const double quarter = std::cos(.25 * (angle[1] - angle[0])), length = a.distance(b) / (quarter * quarter);
      const Tensor1 m = length * Tensor1({std::cos(angle[0]), std::sin(angle[0])});
      const Tensor1 n = length * Tensor1({std::cos(angle[1]), std::sin(angle[1])});
      const Tensor1 chord = b - a;
      return {a + t * t * (3. - 2. * t) * chord + t * (1. - t) * (1. - t) * m - t * t * (1. - t) * n,
              6. * t * (1. - t) * chord + (1. - t) * (1. - 3. * t) * m + t * (3. * t - 2.) * n};
    }

    /// Values of @p n numbers at every place of @p from, interpolated at the places @p to; both ascending.
    std::vector<double> interpolate(const std::vector<double> &from, const std::vector<double> &values,
                                    const std::vector<double> &to)
    {
      const std::size_t n = values.size() / from.size();
      std::vector<double> result;
      for (const double place : to)
      {
        const auto above = std::upper_bound(from.begin(), from.end(), place);
        const auto b = std::min<std::size_t>(static_cast<std::size_t>(above - from.begin()), from.size() - 1);
        const std::size_t a = b > 0 ? b - 1 : 0;
        const double share = b > a ? std::clamp((place - from[a]) / (from[b] - from[a]), 0., 1.) : 0.;
        for (std::size_t i = 0; i < n; ++i)
          result.push_back((1. - share) * values[a * n + i] + share * values[b * n + i]);
      }
      return result;
    }
  } // namespace


  void ShellTransfer::describe(const Vector &q, KeyedArrays &formed) const
  {
    std::vector<Interval> intervals;
    const auto &mesh = space_.mesh();
    for (const auto &cell : mesh.cells())
    {
      // start, (middle,) end
      const std::vector<unsigned int> order =
        space_.degree() == 1 ? std::vector<unsigned int>{0, 1} : std::vector<unsigned int>{0, 2, 1};
      for (std::size_t i = 1; i < order.size(); ++i)
      {
        Interval interval;
        for (unsigned int end = 0; end < 2; ++end)
        {
          const unsigned int local = order[i - 1 + end], node = cell.nodes[local];
          interval.s[end] = mesh.arc_length()[node];
          const Point2 x = space_.position(q, node);
          for (unsigned int d = 0; d < 2; ++d)
          {
            interval.before[end][d] = mesh.nodes()[node][d];
            interval.after[end][d] = x[d];
          }
          interval.angle[end] = cell.angle[local] + space_.rotation(q, node);
        }
        intervals.push_back(interval);
      }
    }
    formed.put("intervals", intervals);
    formed.put("arc length of points", arc_lengths_of_points());
    std::vector<double> layers;
    for (unsigned int l = 0; l < points_.n_layers(); ++l)
      layers.push_back(points_.layer_position(l) / points_.thickness());
    formed.put("layers", layers);
    formed.put("arc length of nodes", mesh.arc_length());
  }


  std::vector<ShellTransfer::Interval> ShellTransfer::intervals_of(const KeyedArrays &formed)
  {
    std::vector<Interval> result;
    formed.take("intervals", result);
    return result;
  }


  ShellTransfer::Place
  ShellTransfer::find(const std::vector<Interval> &intervals, const Point2 &X, const double arc_length) const
  {
    return by_ == Correspondence::place ? find_place(intervals, X) : find_arc_length(intervals, arc_length);
  }


  ShellTransfer::Place ShellTransfer::find_arc_length(const std::vector<Interval> &intervals, const double arc_length)
  {
    const auto ends_before = [](const Interval &interval, const double s) { return interval.s[1] < s; };
    const auto found = std::lower_bound(intervals.begin(), intervals.end() - 1, arc_length, ends_before);
    const double share = (arc_length - found->s[0]) / (found->s[1] - found->s[0]);
    return {static_cast<std::size_t>(found - intervals.begin()), std::clamp(share, 0., 1.), arc_length};
  }


  ShellTransfer::Place ShellTransfer::find_place(const std::vector<Interval> &intervals, const Point2 &X) const
  {
    Place best{0, 0., 0.};
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < intervals.size(); ++i)
    {
      const Interval &interval = intervals[i];
      const Tensor1 chord = between(interval.before, 1.) - between(interval.before, 0.);
      const double share =
        std::clamp((X - between(interval.before, 0.)) * chord / chord.norm_square(), 0., 1.);
      if (const double distance = X.distance(between(interval.before, share)); distance < nearest)
      {
        nearest = distance;
        best = {i, share, (1. - share) * interval.s[0] + share * interval.s[1]};
      }
    }
    if (nearest > .1 * points_.thickness())
      throw SceneError("the blank is no part of the one that was formed: it has a point at R0 = " +
                       std::to_string(X[0]) + ", Z0 = " + std::to_string(X[1]) +
                       ". Its Points are those of the undeformed blank, or of what is left of it by trimming");
    return best;
  }


  void ShellTransfer::set_unknowns(const KeyedArrays &formed, Vector &q) const
  {
    const auto intervals = intervals_of(formed);
    const auto &mesh = space_.mesh();
    for (const auto &cell : mesh.cells())
      for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
      {
        const unsigned int node = cell.nodes[a];
        const Point2 &X = mesh.nodes()[node];
        const Place place = find(intervals, X, mesh.arc_length()[node]);
        const Interval &interval = intervals[place.interval];
        const auto [curve, slope] = cubic(interval.after, interval.angle, place.share);
        const Point2 x = space_.membrane() ? between(interval.after, place.share) : curve;
        for (unsigned int d = 0; d < 2; ++d)
          q[space_.dofs()[node][d]] = x[d] - X[d];
        const double near = (1. - place.share) * interval.angle[0] + place.share * interval.angle[1];
        const double angle = near + std::remainder(std::atan2(slope[1], slope[0]) - near, 2. * dealii::numbers::PI);
        q[space_.dofs()[node][2]] = space_.membrane() ? 0. : angle - cell.angle[a];
      }
    for (const auto dof : space_.fixed_dofs())
      q[dof] = 0.;
  }


  Point2 ShellTransfer::place_of_point(const unsigned int point) const
  {
    const auto &mesh = space_.mesh();
    const auto &cell = mesh.cells()[point / points_.per_cell()];
    Point2 X;
    for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
      X += points_[point].shape[a] * (mesh.nodes()[cell.nodes[a]] - Point2());
    return X;
  }


  std::vector<double> ShellTransfer::arc_lengths_of_points() const
  {
    const auto &mesh = space_.mesh();
    std::vector<double> result(points_.size(), 0.);
    for (unsigned int p = 0; p < points_.size(); ++p)
      for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
        result[p] += points_[p].shape[a] * mesh.arc_length()[mesh.cells()[p / points_.per_cell()].nodes[a]];
    return result;
  }


  void ShellTransfer::set_state(const KeyedArrays &formed, const Vector &q, KeyedArrays &own) const
  {
    const auto &layers = formed.at("layers");
    bool same_layers = layers.size() == points_.n_layers();
    for (unsigned int l = 0; l < points_.n_layers() && same_layers; ++l)
      same_layers = std::abs(layers[l] - points_.layer_position(l) / points_.thickness()) < 1e-9;
    if (!same_layers)
      throw SceneError("the earlier operation had other layers (Blank/Layers, Layer rule): they must stay");
    const auto intervals = intervals_of(formed);
    std::vector<double> to_points = arc_lengths_of_points(), to_nodes = space_.mesh().arc_length();
    for (unsigned int p = 0; p < points_.size(); ++p)
      to_points[p] = find(intervals, place_of_point(p), to_points[p]).arc_length;
    for (unsigned int i = 0; i < space_.n_nodes(); ++i)
      to_nodes[i] = find(intervals, space_.mesh().nodes()[i], to_nodes[i]).arc_length;
    const auto &points = formed.at("arc length of points"), &nodes = formed.at("arc length of nodes");
    const KeyedArrays sizes = own;
    for (const auto &[name, values] : sizes.all())
    {
      const std::vector<double> &before = formed.at(name);
      if (before.size() == nodes.size() && values.size() == to_nodes.size())
        own.put(name, interpolate(nodes, before, to_nodes));
      else if (!before.empty() && before.size() % points.size() == 0 && values.size() % to_points.size() == 0)
        own.put(name, interpolate(points, before, to_points));
    }
    keep_stress(q, own);
  }


  void ShellTransfer::keep_stress(const Vector &q, KeyedArrays &own) const
  {
    const HistoryLayout &layout = material_.law().history_layout();
    const HistoryField *const plastic = layout.find("plastic_strain");
    std::vector<double> strain = own.at("strain"), ratio = own.at("thickness ratio");
    const unsigned int n_layers = points_.n_layers();
    std::vector<double> change(strain.size(), 0.);
    for (unsigned int p = 0; p < points_.size(); ++p)
    {
      const ShellPoint &point = points_[p];
      const ShellStrain now = points_.strain(q, p / points_.per_cell(), p);
      // The layers lie where the new thickness has them, which follows from their strains: a contraction by the bending
      // strain.
      for (unsigned int i = 0; i < 4; ++i)
      {
        double thickness = 0.;
        for (unsigned int l = 0; l < n_layers; ++l)
        {
          const double position = points_.layer_position(l), zeta = ratio[p] * position;
          const double *const e = &strain[4 * (p * n_layers + l)];
          double *const d = &change[4 * (p * n_layers + l)];
          d[0] = std::log((now.lambda - zeta * now.theta_prime) / (point.lambda - position * point.angle_prime)) - e[0];
          if (space_.axisymmetric())
            d[1] = std::log((now.r + zeta * now.d_r()) / (point.radius - position * std::sin(point.angle))) - e[1];
          d[2] = plastic != nullptr ? -d[0] - d[1] : 0.;
          thickness += points_.layer_weight(l) / points_.thickness() * std::exp(e[2] + d[2]);
        }
        ratio[p] = thickness;
      }
    }
    for (std::size_t i = 0; i < strain.size(); ++i)
      strain[i] += change[i];
    own.put("strain", strain);
    own.put("thickness ratio", ratio);
    own.put("ratio of layers", ratio);
    if (plastic == nullptr)
      return;
    const KeyedArrays before = own;
    for (const auto &[name, values] : before.all())
      if (name.rfind("history, ", 0) == 0)
      {
        std::vector<double> history = values;
        for (std::size_t i = 0; i < change.size() / 4; ++i)
          for (unsigned int k = 0; k < 3; ++k)
            history[i * layout.size() + plastic->first + k] += change[4 * i + k];
        own.put(name, history);
      }
  }
} // namespace deltaform
