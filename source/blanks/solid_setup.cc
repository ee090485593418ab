// Unknowns, quadrature points and boundary of the solid.
#include "solid.h"

#include <deltaform/base/ranks.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>

#include <Eigen/Dense>

#include <algorithm>

namespace deltaform
{
  using dealii::numbers::PI;

  void Solid::set_up_dofs(const CellPlaces &places)
  {
    if (!element_)
      element_ = std::make_unique<dealii::FESystem<2>>(dealii::FE_Q<2>(degree_), 2);
    dof_handler_.distribute_dofs(*element_);
    n_nodes_per_cell_ = (degree_ + 1) * (degree_ + 1);
    const std::vector<DofIndex> number = set_up_hanging_nodes();
    cells_.clear();
    nodes_.clear();
    parameters_.clear();
    node_dofs_.clear();

    if (ranks::count() > 1)
    {
      set_up_distributed_dofs(number, places);
      return;
    }

    const dealii::FE_Q<2> scalar(degree_);
    // Curved boundaries of degree 2 where the mesh has manifolds
    const dealii::MappingQ<2> mapping(degree_);
    std::vector<unsigned int> node_of_dof(dof_handler_.n_dofs(), invalid_index);
    std::vector<DofIndex> dofs(element_->n_dofs_per_cell());
    for (const auto &cell : dof_handler_.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      std::array<unsigned int, 9> nodes{};
      for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
      {
        const auto dof = dofs[element_->component_to_system_index(0, a)];
        if (node_of_dof[dof] == invalid_index)
        {
          node_of_dof[dof] = nodes_.size();
          parameters_.push_back(mapping.transform_unit_to_real_cell(cell, scalar.unit_support_point(a)));
          nodes_.push_back(places ? places(cells_.size(), a) : mesh_.place(parameters_.back()));
          node_dofs_.push_back({{number[dof], number[dofs[element_->component_to_system_index(1, a)]]}});
        }
        nodes[a] = node_of_dof[dof];
      }
      cells_.push_back(nodes);
    }
  }


  void Solid::set_up_points()
  {
    const dealii::FE_Q<2> shapes(degree_);
    const dealii::QGauss<2> quadrature(degree_ + 1);
    const unsigned int n = quadrature.size(), n_modes = degree_ == 1 ? 1 : 3;
    n_points_per_cell_ = n;
    quadrature_ = quadrature.get_points();

    // The same on every cell: values and gradients of the shapes on the unit square.
    std::vector<std::array<double, 9>> values(n);
    std::vector<std::array<Tensor1, 9>> gradients(n);
    for (unsigned int p = 0; p < n; ++p)
      for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
      {
        values[p][a] = shapes.shape_value(a, quadrature.point(p));
        gradients[p][a] = shapes.shape_grad(a, quadrature.point(p));
      }

    points_.clear();
    points_.reserve(cells_.size() * n);
    projection_.clear();
    projection_.reserve(points_.capacity() * n);
    constant_matrices_.clear();
    for (const auto &cell : cells_)
    {
      for (unsigned int p = 0; p < n; ++p)
      {
        QuadraturePoint point;
        Tensor2 jacobian; // dX/dxi
        double radius = 0;
        for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
        {
          const Point2 &X = nodes_[cell[a]];
          point.shape[a] = values[p][a];
          radius += point.shape[a] * X[0];
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int j = 0; j < 2; ++j)
              jacobian[i][j] += X[i] * gradients[p][a][j];
        }
        const double determinant = dealii::determinant(jacobian);
        point.radius = axisymmetric_ ? radius : 1.;
        point.weight = (axisymmetric_ ? 2 * PI * radius : 1.) * determinant * quadrature.weight(p);
        if (point.weight > 0)
        {
          const Tensor2 inverse = dealii::invert(jacobian);
          for (unsigned int a = 0; a < n_nodes_per_cell_; ++a)
          {
            const Tensor1 gradient = gradients[p][a] * inverse;
            point.gradient_r[a] = gradient[0];
            point.gradient_z[a] = gradient[1];
          }
        }
        points_.push_back(point);
      }
      // Least squares by volume on 1 (degree 1) or 1, xi, eta (degree 2)
      Eigen::MatrixXd modes(n, n_modes), weights = Eigen::MatrixXd::Zero(n, n);
      for (unsigned int p = 0; p < n; ++p)
      {
        modes(p, 0) = 1.;
        for (unsigned int k = 1; k < n_modes; ++k)
          modes(p, k) = quadrature.point(p)[k - 1] - .5;
        weights(p, p) = points_[points_.size() - n + p].weight;
      }
      const Eigen::MatrixXd projection =
        modes * (modes.transpose() * weights * modes).ldlt().solve(modes.transpose() * weights);
      for (unsigned int p = 0; p < n; ++p)
        for (unsigned int k = 0; k < n; ++k)
          projection_.push_back(projection(p, k));
    }

    material_.reset(points_.size());
    if (material_.carries())
      spin_.assign(points_.size(), Turn());
    deformation_.assign(points_.size(), Deformation());
    committed_deformation_ = deformation_;
    volume_offset_.assign(points_.size(), 0.);
    plastic_metric_.assign(points_.size(), {{1., 1., 1., 0.}});

    if (finite_ || material_.plastic())
      return;
    // Are the moduli the same at zero and at some strain?
    std::array<Mandel, 2> strain{{{}, {{1e-3, -2e-3, 5e-4, 7e-4}}}}, stress;
    std::array<double, 32> moduli;
    MaterialBatch batch;
    batch.n_points = 2;
    batch.strain = strain.data();
    batch.stress = stress.data();
    batch.tangent = moduli.data();
    linear_ =
      material_.law().update(batch).good() && std::equal(moduli.begin(), moduli.begin() + 16, moduli.begin() + 16);
  }


  void Solid::set_up_boundary()
  {
    // Corners and middle of each face of a cell, walked counterclockwise
    constexpr unsigned int walk[4][3] = {{2, 0, 4}, {1, 3, 5}, {0, 1, 6}, {3, 2, 7}};
    columns_.clear();
    boundary_edges_.clear();
    edge_cells_.clear();
    for (const auto &name : mesh_.boundaries())
      boundary_edges_[name];
    struct BoundaryEdge
    {
      unsigned int boundary;
      Edge edge;
    };
    std::vector<BoundaryEdge> own;
    unsigned int c = 0;
    for (const auto &cell : dof_handler_.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      const auto &nodes = cells_[c];
      for (unsigned int f = 0; f < 4; ++f)
        if (cell->face(f)->at_boundary())
        {
          own.push_back({cell->face(f)->boundary_id(),
                         {{nodes[walk[f][0]], nodes[walk[f][1]], degree_ == 2 ? nodes[walk[f][2]] : invalid_index}}});
          edge_cells_[std::minmax(nodes[walk[f][0]], nodes[walk[f][1]])] = c;
        }
      ++c;
    }
    for (const auto &[boundary, edge] : ranks::gather(own))
      boundary_edges_[mesh_.boundaries()[boundary]].push_back(edge);
    if (!mesh_.is_strip())
      return;
    std::map<long, std::array<unsigned int, 2>> stations;
    for (unsigned int i = 0; i < nodes_.size(); ++i)
      for (const unsigned int side : {0, 1})
        if (std::abs(parameters_[i][1] - (side - .5)) < 1e-9)
          stations.insert({station(i), {{invalid_index, invalid_index}}}).first->second[side] = i;
    // Where only one side is refined, there is no column.
    for (const auto &[place, pair] : stations)
      if (pair[0] != invalid_index && pair[1] != invalid_index)
        columns_.push_back(pair);
  }


  void Solid::set_up_face(ContactFace &face, const std::vector<std::string> &names)
  {
    face = ContactFace();
    // Chains: an edge is followed by the one that starts where it ends.
    std::map<unsigned int, Edge> starts;
    std::map<unsigned int, unsigned int> ends;
    for (const auto &name : names)
      for (const auto &edge : edges(name))
      {
        starts[edge[0]] = edge;
        ++ends[edge[1]];
      }
    while (!starts.empty())
    {
      auto first = starts.begin();
      for (auto it = starts.begin(); it != starts.end(); ++it)
        if (ends.count(it->first) == 0)
        {
          first = it;
          break;
        }
      std::vector<Edge> chain;
      for (auto it = first; it != starts.end(); it = starts.find(chain.back()[1]))
      {
        chain.push_back(it->second);
        ends.erase(it->second[1]);
        starts.erase(it);
      }
      // From the axis outwards, or upwards: arc lengths are read that way.
      const Point2 &A = nodes_[chain.front()[0]], &B = nodes_[chain.back()[1]];
      if (B[0] < A[0] || (B[0] == A[0] && B[1] < A[1]))
      {
        std::reverse(chain.begin(), chain.end());
        for (auto &edge : chain)
          std::swap(edge[0], edge[1]);
      }
      const auto add = [&](const unsigned int node) {
        face.arc.push_back(face.nodes.empty() ? 0.
                                              : face.arc.back() + nodes_[node].distance(nodes_[face.nodes.back()]));
        face.nodes.push_back(node);
        return static_cast<unsigned int>(face.nodes.size() - 1);
      };
      const bool closed = chain.size() > 1 && chain.front()[0] == chain.back()[1];
      const unsigned int head = add(chain.front()[0]);
      for (const auto &edge : chain)
      {
        Edge own{{static_cast<unsigned int>(face.nodes.size() - 1), 0, invalid_index}};
        if (degree_ == 2)
          own[2] = add(edge[2]);
        own[1] = closed && &edge == &chain.back() ? head : add(edge[1]);
        face.edges.push_back(own);
      }
    }
    face.area.assign(face.nodes.size(), 0.);
    face.weightless.assign(face.nodes.size(), false);
  }


  void Solid::set_up_weightless()
  {
    const Vector zero(n_dofs());
    update_areas(zero);
    for (auto &face : faces_)
      for (unsigned int i = 0; i < face.nodes.size(); ++i)
        face.weightless[i] = face.area[i] < 1e-9 * shortest_edge_ * (axisymmetric_ ? shortest_edge_ : 1.);
    update_areas(zero);
  }
} // namespace deltaform
