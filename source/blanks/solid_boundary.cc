// Loads on the boundary and the volume of the solid, and its faces as contact sees them.
#include <deltaform/base/assembly_target.h>
#include <deltaform/base/ranks.h>
#include <deltaform/blanks/solid.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  using dealii::numbers::PI;

  namespace
  {
    /// Point of the quadrature of an edge: shape functions of its start, end and middle, derivatives, weight.
    struct EdgePoint
    {
      std::array<double, 3> shape, gradient;
      double weight;
    };

    /// Gauss rule with three points: exact for shape function, radius and length of a straight edge of degree 2.
    const std::array<EdgePoint, 3> &edge_quadrature(const unsigned int degree)
    {
      static const auto make = [](const unsigned int n) {
        std::array<EdgePoint, 3> result;
        const double distance = .5 * std::sqrt(.6);
        for (unsigned int k = 0; k < 3; ++k)
        {
          const double x = .5 + (k - 1.) * distance;
          result[k].weight = k == 1 ? 4. / 9. : 5. / 18.;
          if (n == 1)
          {
            result[k].shape = {{1 - x, x, 0.}};
            result[k].gradient = {{-1., 1., 0.}};
          }
          else
          {
            result[k].shape = {{(1 - x) * (1 - 2 * x), x * (2 * x - 1), 4 * x * (1 - x)}};
            result[k].gradient = {{4 * x - 3, 4 * x - 1, 4 - 8 * x}};
          }
        }
        return result;
      };
      static const std::array<std::array<EdgePoint, 3>, 2> rules{{make(1), make(2)}};
      return rules[degree - 1];
    }
  } // namespace


  Point2 Solid::position(const Vector &q, const unsigned int node) const
  {
    return nodes_[node] + Tensor1({q[node_dofs_[node][0]], q[node_dofs_[node][1]]});
  }


  void Solid::edge_weights(const std::array<Point2, 3> &x, std::array<double, 3> &result) const
  {
    result.fill(0.);
    for (const auto &[shape, gradient, weight] : edge_quadrature(degree_))
    {
      Tensor1 x_xi;
      double r = 0;
      for (unsigned int a = 0; a <= degree_; ++a)
      {
        x_xi += gradient[a] * x[a];
        r += shape[a] * x[a][0];
      }
      const double dA = (axisymmetric_ ? 2 * PI * r : 1.) * x_xi.norm() * weight;
      for (unsigned int a = 0; a <= degree_; ++a)
        result[a] += shape[a] * dA;
    }
  }


  void Solid::update_areas(const Vector &q) const
  {
    const Vector none(q.size());
    const Vector &where = finite_ ? q : none;
    for (const auto &face : faces_)
    {
      std::fill(face.area.begin(), face.area.end(), 0.);
      for (const auto &edge : face.edges)
      {
        std::array<Point2, 3> x;
        std::array<double, 3> weights;
        for (unsigned int a = 0; a <= degree_; ++a)
          x[a] = position(where, face.nodes[edge[a]]);
        edge_weights(x, weights);
        for (unsigned int a = 0; a <= degree_; ++a)
          face.area[edge[a]] += weights[a];
      }
      // Degree 2: the share of a node on the axis vanishes in the initial configuration: it has no contact.
      for (unsigned int i = 0; i < face.nodes.size(); ++i)
        if (face.weightless[i])
          face.area[i] = 0.;
    }
  }


  std::vector<double> Solid::boundary_weights(const std::string &boundary) const
  {
    const auto on_boundary = boundary_nodes(boundary);
    std::vector<double> result(on_boundary.size(), 0.);
    for (const auto &edge : edges(boundary))
    {
      std::array<Point2, 3> x;
      std::array<double, 3> weights;
      for (unsigned int a = 0; a <= degree_; ++a)
        x[a] = nodes_[edge[a]];
      edge_weights(x, weights);
      for (unsigned int a = 0; a <= degree_; ++a)
        result[std::lower_bound(on_boundary.begin(), on_boundary.end(), edge[a]) - on_boundary.begin()] += weights[a];
    }
    return result;
  }


  std::vector<std::pair<DofIndex, double>> Solid::volume_weights(const Component component) const
  {
    if (component == Component::rotation)
      return {};
    struct Share
    {
      DofIndex dof;
      double volume;
    };
    std::vector<Share> own;
    for (unsigned int p = 0; p < points_.size(); ++p)
      for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
      {
        const DofIndex dof = node_dofs_[cells_[p / n_points_per_cell_][a]][static_cast<unsigned int>(component)];
        const double weight = points_[p].shape[a] * points_[p].weight;
        if (dof < n_free_)
          own.push_back({dof, weight});
        else
          for (const auto &[master, share] : hanging_[dof - n_free_])
            own.push_back({master, share * weight});
      }
    std::vector<std::pair<DofIndex, double>> result;
    for (const auto &[dof, volume] : ranks::gather(own))
      result.emplace_back(dof, volume);
    return result;
  }


  void Solid::assemble_pressure(const Vector &q,
                                const std::string &face,
                                const double pressure,
                                const bool following,
                                AssemblyTarget &target) const
  {
    const unsigned int n_nodes = degree_ + 1, n = 2 * n_nodes;
    const bool moves = following && finite_, tangent = target.wants_tangent() && moves;
    std::array<DofIndex, 6> dofs;
    std::array<double, 6> residual;
    std::array<double, 36> matrix;
    for (const auto &edge : edges(face))
    {
      residual.fill(0.);
      matrix.fill(0.);
      std::array<Point2, 3> x;
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        x[a] = moves ? position(q, edge[a]) : nodes_[edge[a]];
        for (unsigned int k = 0; k < 2; ++k)
          dofs[2 * a + k] = node_dofs_[edge[a]][k];
      }
      for (const auto &[shape, gradient, weight] : edge_quadrature(degree_))
      {
        Tensor1 x_xi;
        double r = 0;
        for (unsigned int a = 0; a < n_nodes; ++a)
        {
          x_xi += gradient[a] * x[a];
          r += shape[a] * x[a][0];
        }
        if (!axisymmetric_)
          r = 1.;
        const double w = (axisymmetric_ ? 2 * PI : 1.) * weight * pressure;
        for (unsigned int a = 0; a < n_nodes; ++a)
        {
          // The body lies to the left of the edge: inwards is (-z', r').
          residual[2 * a] += w * shape[a] * r * x_xi[1];
          residual[2 * a + 1] -= w * shape[a] * r * x_xi[0];
          if (tangent)
            for (unsigned int b = 0; b < n_nodes; ++b)
            {
              double *row_r = &matrix[2 * a * n + 2 * b];
              double *row_z = row_r + n;
              row_r[1] += w * shape[a] * r * gradient[b];
              row_z[0] -= w * shape[a] * r * gradient[b];
              if (axisymmetric_)
              {
                row_r[0] += w * shape[a] * x_xi[1] * shape[b];
                row_z[0] -= w * shape[a] * x_xi[0] * shape[b];
              }
            }
        }
      }
      target.add(dofs.data(), n, target.wants_tangent() ? matrix.data() : nullptr, residual.data());
    }
  }


  unsigned int Solid::n_contact_nodes(const Side side) const
  {
    return faces_[static_cast<unsigned int>(side)].nodes.size();
  }


  const std::vector<std::array<unsigned int, 3>> &Solid::contact_edges(const Side side) const
  {
    return faces_[static_cast<unsigned int>(side)].edges;
  }


  void Solid::contact_node(const Vector &q,
                           const Side side,
                           const unsigned int node,
                           ContactThickness,
                           ContactNode &result) const
  {
    const ContactFace &face = faces_[static_cast<unsigned int>(side)];
    const unsigned int own = face.nodes[node];
    result.node = own;
    result.n_dofs = 2;
    result.dofs = {{node_dofs_[own][0], node_dofs_[own][1], 0}};
    result.x = position(q, own);
    result.offset = 0.;
    result.area = face.area[node];
    result.reference_coordinate = nodes_[own][0];
    result.arc_coordinate = face.arc[node];
    result.thickness = shortest_edge_;
    result.jacobian = {{Tensor1({1., 0.}), Tensor1({0., 1.}), Tensor1()}};
    result.second = {};
  }
} // namespace deltaform
