#include "solid_boundary.h"

#include <deltaform/parameters/text.h>
#include <deltaform/process/ranks.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace deltaform
{
  /// An edge with the number of the part that it belongs to.
  struct NamedEdge
  {
    unsigned int part;
    Edge edge;
  };


  namespace
  {
    using CellOfEdge = std::map<std::pair<unsigned int, unsigned int>, unsigned int>;


    /// Those of the own cells; @p cell_of: which cell has an edge, by its ends.
    std::vector<NamedEdge> own_edges(const SolidSpace &space, CellOfEdge &cell_of)
    {
      // Corners and middle of each face of a cell, walked counterclockwise
      constexpr unsigned int walk[4][3] = {{2, 0, 4}, {1, 3, 5}, {0, 1, 6}, {3, 2, 7}};
      cell_of.clear();
      std::vector<NamedEdge> result;
      unsigned int c = 0;
      for (const auto &cell : space.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const auto &nodes = space.cells()[c];
        for (unsigned int f = 0; f < 4; ++f)
          if (cell->face(f)->at_boundary())
          {
            const unsigned int middle = space.degree() == 2 ? nodes[walk[f][2]] : invalid_index;
            result.push_back({cell->face(f)->boundary_id(), {{nodes[walk[f][0]], nodes[walk[f][1]], middle}}});
            cell_of[std::minmax(nodes[walk[f][0]], nodes[walk[f][1]])] = c;
          }
        ++c;
      }
      return result;
    }
  } // namespace


  void SolidBoundary::set_up()
  {
    edges_.clear();
    for (const auto &name : space_.mesh().boundaries())
      edges_[name];
    for (const auto &[part, edge] : ranks::gather(own_edges(space_, cells_)))
      edges_[space_.mesh().boundaries()[part]].push_back(edge);
    set_up_columns();
  }


  void SolidBoundary::set_up_columns()
  {
    columns_.clear();
    if (!space_.mesh().is_strip())
      return;
    std::map<long, std::array<unsigned int, 2>> cross_sections;
    for (unsigned int i = 0; i < space_.nodes().size(); ++i)
      for (const unsigned int side : {0, 1})
        if (std::abs(space_.parameter(i)[1] - (side - .5)) < 1e-9)
          cross_sections.insert({space_.cross_section(i), {{invalid_index, invalid_index}}}).first->second[side] = i;
    // Where only one side is refined, there is no column.
    for (const auto &[place, pair] : cross_sections)
      if (pair[0] != invalid_index && pair[1] != invalid_index)
        columns_.push_back(pair);
  }


  const std::vector<Edge> &SolidBoundary::edges(const std::string &part) const
  {
    const auto found = edges_.find(part);
    if (found == edges_.end())
      throw std::invalid_argument("this solid has no boundary '" + part + "', only " +
                                  text::join(space_.mesh().boundaries(), ", "));
    return found->second;
  }


  std::vector<unsigned int> SolidBoundary::nodes(const std::string &part) const
  {
    std::set<unsigned int> result;
    for (const auto &edge : edges(part))
      result.insert(edge.begin(), edge.begin() + space_.degree() + 1);
    return {result.begin(), result.end()};
  }


  std::vector<std::string> SolidBoundary::parts() const
  {
    return space_.mesh().boundaries();
  }


  std::vector<std::string> SolidBoundary::faces() const
  {
    return parts();
  }


  std::vector<unsigned int> SolidBoundary::face_nodes(const std::string &face) const
  {
    return nodes(face);
  }


  std::vector<DofIndex> SolidBoundary::dofs(const std::string &part, const Component component) const
  {
    std::vector<DofIndex> result;
    for (const auto node : nodes(part))
      if (component != Component::rotation)
        result.push_back(space_.dofs()[node][static_cast<unsigned int>(component)]);
    return result;
  }


  std::vector<Point2> SolidBoundary::points(const std::string &part) const
  {
    std::vector<Point2> result;
    for (const auto node : nodes(part))
      result.push_back(space_.nodes()[node]);
    return result;
  }


  std::vector<std::pair<DofIndex, double>> SolidBoundary::volume_weights(const Component component) const
  {
    if (component == Component::rotation)
      return {};
    return points_.volume_weights(static_cast<unsigned int>(component));
  }


  std::vector<std::vector<LineNode>> SolidBoundary::lines() const
  {
    std::vector<std::vector<LineNode>> result;
    for (const std::string part : {"bottom", "top"})
    {
      if (!space_.mesh().is_strip() || !has(part))
        return {};
      std::vector<unsigned int> along = nodes(part);
      std::sort(along.begin(), along.end(),
                [this](const unsigned int a, const unsigned int b) {
                  return space_.cross_section(a) < space_.cross_section(b);
                });
      std::vector<LineNode> line;
      double arc = 0.;
      for (unsigned int i = 0; i < along.size(); ++i)
      {
        const Point2 &x = space_.nodes()[along[i]];
        arc += i > 0 ? x.distance(space_.nodes()[along[i - 1]]) : 0.;
        line.push_back({arc, x[0], space_.dofs()[along[i]][0]});
      }
      result.push_back(line);
    }
    return result;
  }


  std::vector<double> SolidBoundary::weights(const std::string &part) const
  {
    const auto on_part = nodes(part);
    std::vector<double> result(on_part.size(), 0.);
    for (const auto &edge : edges(part))
    {
      std::array<Point2, 3> x;
      for (unsigned int a = 0; a <= space_.degree(); ++a)
        x[a] = space_.nodes()[edge[a]];
      const auto areas = edge_areas(x, space_.degree(), space_.axisymmetric());
      for (unsigned int a = 0; a <= space_.degree(); ++a)
        result[std::lower_bound(on_part.begin(), on_part.end(), edge[a]) - on_part.begin()] += areas[a];
    }
    return result;
  }


  void SolidBoundary::edge_pressure(const std::array<Point2, 3> &x,
                                    const double pressure,
                                    const bool tangent,
                                    std::array<double, 6> &residual,
                                    Matrix &matrix) const
  {
    const bool axisymmetric = space_.axisymmetric();
    const unsigned int n_nodes = space_.degree() + 1, n = 2 * n_nodes;
    for (const auto &[shape, gradient, weight] : edge_quadrature(space_.degree()))
    {
      Tensor1 x_xi;
      double r = 0;
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        x_xi += gradient[a] * x[a];
        r += shape[a] * x[a][0];
      }
      if (!axisymmetric)
        r = 1.;
      const double w = (axisymmetric ? 2 * dealii::numbers::PI : 1.) * weight * pressure;
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
            if (axisymmetric)
            {
              row_r[0] += w * shape[a] * x_xi[1] * shape[b];
              row_z[0] -= w * shape[a] * x_xi[0] * shape[b];
            }
          }
      }
    }
  }


  void SolidBoundary::assemble_pressure(const Vector &q,
                                        const std::string &face,
                                        const double pressure,
                                        const bool following,
                                        AssemblyTarget &target) const
  {
    const bool current = following && moves_;
    const unsigned int n_nodes = space_.degree() + 1;
    std::array<DofIndex, 6> dofs;
    std::array<double, 6> residual;
    Matrix matrix;
    for (const auto &edge : edges(face))
    {
      residual.fill(0.);
      matrix.fill(0.);
      std::array<Point2, 3> x;
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        x[a] = current ? space_.position(q, edge[a]) : space_.nodes()[edge[a]];
        for (unsigned int k = 0; k < 2; ++k)
          dofs[2 * a + k] = space_.dofs()[edge[a]][k];
      }
      edge_pressure(x, pressure, target.wants_tangent() && current, residual, matrix);
      target.add(dofs.data(), 2 * n_nodes, target.wants_tangent() ? matrix.data() : nullptr, residual.data());
    }
  }


  unsigned int SolidBoundary::cell(const unsigned int a, const unsigned int b) const
  {
    const auto found = cells_.find(std::minmax(a, b));
    return found != cells_.end() ? found->second : invalid_index;
  }
} // namespace deltaform
