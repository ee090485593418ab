#include "solid_face.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace deltaform
{
  void SolidFace::set_up(const SolidBoundary &boundary, const std::vector<std::string> &parts)
  {
    nodes_.clear();
    edges_.clear();
    arc_.clear();
    // Chains: an edge is followed by the one that starts where it ends.
    std::map<unsigned int, Edge> starts;
    std::map<unsigned int, unsigned int> ends;
    for (const auto &part : parts)
      for (const auto &edge : boundary.edges(part))
      {
        starts[edge[0]] = edge;
        ++ends[edge[1]];
      }
    while (!starts.empty())
    {
      const auto begins = [&](const auto &start) { return ends.count(start.first) == 0; };
      auto first = std::find_if(starts.begin(), starts.end(), begins);
      if (first == starts.end())
        first = starts.begin();
      std::vector<Edge> chain;
      for (auto it = first; it != starts.end(); it = starts.find(chain.back()[1]))
      {
        chain.push_back(it->second);
        ends.erase(it->second[1]);
        starts.erase(it);
      }
      // From the axis outwards, or upwards: arc lengths are read that way.
      const Point2 &A = space_.nodes()[chain.front()[0]], &B = space_.nodes()[chain.back()[1]];
      if (B[0] < A[0] || (B[0] == A[0] && B[1] < A[1]))
      {
        std::reverse(chain.begin(), chain.end());
        for (auto &edge : chain)
          std::swap(edge[0], edge[1]);
      }
      add(chain);
    }
    weightless_.assign(nodes_.size(), false);
  }


  unsigned int SolidFace::add(const unsigned int node)
  {
    const auto &X = space_.nodes();
    arc_.push_back(nodes_.empty() ? 0. : arc_.back() + X[node].distance(X[nodes_.back()]));
    nodes_.push_back(node);
    return nodes_.size() - 1;
  }


  void SolidFace::add(const std::vector<Edge> &chain)
  {
    const bool closed = chain.size() > 1 && chain.front()[0] == chain.back()[1];
    const unsigned int head = add(chain.front()[0]);
    for (const auto &edge : chain)
    {
      Edge own{{static_cast<unsigned int>(nodes_.size() - 1), 0, invalid_index}};
      if (space_.degree() == 2)
        own[2] = add(edge[2]);
      own[1] = closed && &edge == &chain.back() ? head : add(edge[1]);
      edges_.push_back(own);
    }
  }


  void SolidFace::set_up_areas(const double length)
  {
    const Vector zero(space_.hanging().n_unknowns());
    const std::vector<double> areas = areas_at(zero);
    for (unsigned int i = 0; i < nodes_.size(); ++i)
      weightless_[i] = areas[i] < 1e-9 * length * (space_.axisymmetric() ? length : 1.);
    areas_.reset(areas_at(zero));
  }


  std::vector<double> SolidFace::areas_at(const Vector &q) const
  {
    std::vector<double> result(nodes_.size(), 0.);
    for (const auto &edge : edges_)
    {
      std::array<Point2, 3> x;
      for (unsigned int a = 0; a <= space_.degree(); ++a)
        x[a] = space_.position(q, nodes_[edge[a]]);
      const auto areas = edge_areas(x, space_.degree(), space_.axisymmetric());
      for (unsigned int a = 0; a <= space_.degree(); ++a)
        result[edge[a]] += areas[a];
    }
    for (unsigned int i = 0; i < nodes_.size(); ++i)
      if (weightless_[i])
        result[i] = 0.;
    return result;
  }


  void SolidFace::contact_point(const Vector &q, const unsigned int node, ContactPoint &result) const
  {
    const unsigned int own = nodes_[node];
    const auto &dofs = space_.dofs()[own];
    result.set_node(own);
    result.n_dofs = 2;
    result.dofs[0] = dofs[0];
    result.dofs[1] = dofs[1];
    result.x = space_.position(q, own);
    result.offset = 0.;
    result.area = areas_.values()[node];
    result.reference_coordinate = space_.nodes()[own][0];
    result.arc_coordinate = arc_[node];
    result.jacobian[0] = Tensor1({1., 0.});
    result.jacobian[1] = Tensor1({0., 1.});
  }


  void SolidFace::contact_place(const Vector &q, const unsigned int edge, const double xi, ContactPoint &result) const
  {
    const EdgePoint at = edge_point(space_.degree(), xi);
    result = ContactPoint();
    result.n_nodes = space_.degree() + 1;
    result.n_dofs = 2 * result.n_nodes;
    // The node with the largest share comes first.
    std::array<unsigned int, 3> order{{0, 1, 2}};
    std::swap(order[0], order[std::max_element(at.shape.begin(), at.shape.end()) - at.shape.begin()]);
    Tensor1 along;
    for (unsigned int i = 0; i < result.n_nodes; ++i)
    {
      const unsigned int a = order[i], node = edges_[edge][a], own = nodes_[node];
      const Point2 x = space_.position(q, own);
      result.nodes[i] = {own, at.shape[a]};
      for (unsigned int d = 0; d < 2; ++d)
      {
        result.dofs[2 * i + d] = space_.dofs()[own][d];
        result.x[d] += at.shape[a] * x[d];
        along[d] += at.gradient[a] * x[d];
        result.jacobian[2 * i + d][d] = at.shape[a];
      }
      result.reference_coordinate += at.shape[a] * space_.nodes()[own][0];
      result.arc_coordinate += at.shape[a] * arc_[node];
    }
    result.area = along.norm() * (space_.axisymmetric() ? 2. * dealii::numbers::PI * result.x[0] : 1.);
  }


  double SolidFace::distance(const Vector &q, const Point2 &x) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto &edge : edges_)
    {
      const Point2 a = space_.position(q, nodes_[edge[0]]), b = space_.position(q, nodes_[edge[1]]);
      const Tensor1 along = b - a;
      const double t = std::clamp(((x - a) * along) / along.norm_square(), 0., 1.);
      nearest = std::min(nearest, (x - (a + t * along)).norm_square());
    }
    return std::sqrt(nearest);
  }


  double SolidFace::shortest_edge() const
  {
    double result = std::numeric_limits<double>::infinity();
    for (const auto &edge : edges_)
    {
      const auto [a, b] = ends(edge);
      result = std::min(result, space_.nodes()[a].distance(space_.nodes()[b]) / space_.degree());
    }
    return result;
  }


  std::vector<Point2> SolidFace::places() const
  {
    std::vector<Point2> result;
    for (const auto node : nodes_)
      result.push_back(space_.nodes()[node]);
    return result;
  }
} // namespace deltaform
