#include "shell_boundary.h"

#include <numeric>
#include <stdexcept>

namespace deltaform
{
  std::vector<std::string> ShellBoundary::parts() const
  {
    return {"start", "end"};
  }


  unsigned int ShellBoundary::node(const std::string &part) const
  {
    if (part == "start")
      return 0;
    if (part == "end")
      return space_.n_nodes() - 1;
    throw std::invalid_argument("a shell has no boundary '" + part + "', only 'start' and 'end'");
  }


  std::vector<DofIndex> ShellBoundary::dofs(const std::string &part, const Component component) const
  {
    return {space_.dofs()[node(part)][static_cast<unsigned int>(component)]};
  }


  std::vector<Point2> ShellBoundary::points(const std::string &part) const
  {
    return {space_.mesh().nodes()[node(part)]};
  }


  std::vector<double> ShellBoundary::weights(const std::string &part) const
  {
    return {space_.axisymmetric() ? 2 * dealii::numbers::PI * points(part).front()[0] : 1.};
  }


  std::vector<std::string> ShellBoundary::faces() const
  {
    return {"bottom"};
  }


  std::vector<unsigned int> ShellBoundary::face_nodes(const std::string & /*face*/) const
  {
    std::vector<unsigned int> all(space_.n_nodes());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }


  std::vector<std::pair<DofIndex, double>> ShellBoundary::volume_weights(const Component component) const
  {
    if (component == Component::rotation)
      return {};
    const auto areas = surface_.areas_at(Vector(space_.n_dofs()));
    std::vector<std::pair<DofIndex, double>> result;
    for (unsigned int i = 0; i < space_.n_nodes(); ++i)
      result.emplace_back(space_.dofs()[i][static_cast<unsigned int>(component)], thickness_ * areas[i]);
    return result;
  }


  std::vector<std::vector<LineNode>> ShellBoundary::lines() const
  {
    const auto &mesh = space_.mesh();
    std::vector<LineNode> line;
    for (unsigned int i = 0; i < space_.n_nodes(); ++i)
      line.push_back({mesh.arc_length()[i], mesh.nodes()[i][0], space_.dofs()[i][0]});
    return {line};
  }


  void ShellBoundary::cell_pressure(const std::array<Point2, 3> &x,
                                    const double pressure,
                                    const bool tangent,
                                    Residual &residual,
                                    Matrix &matrix) const
  {
    const bool axisymmetric = space_.axisymmetric();
    const unsigned int n_nodes = space_.n_nodes_per_cell(), n_dofs = 3 * n_nodes;
    const double factor = axisymmetric ? 2 * dealii::numbers::PI : 1.;
    for (const auto &[shape, gradient, weight] : space_.load_quadrature())
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
      const double w = factor * weight * pressure;
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        residual[3 * a] -= w * shape[a] * r * (-x_xi[1]);
        residual[3 * a + 1] -= w * shape[a] * r * x_xi[0];
        if (tangent)
          for (unsigned int b = 0; b < n_nodes; ++b)
          {
            double *row_r = &matrix[(3 * a) * n_dofs + 3 * b];
            double *row_z = &matrix[(3 * a + 1) * n_dofs + 3 * b];
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


  void ShellBoundary::assemble_pressure(const Vector &q,
                                        const std::string & /*face*/,
                                        const double pressure,
                                        const bool following,
                                        AssemblyTarget &target) const
  {
    const unsigned int n_nodes = space_.n_nodes_per_cell();
    const bool tangent = target.wants_tangent() && following;
    std::array<DofIndex, 9> dofs;
    Residual residual;
    Matrix matrix;
    for (const auto &cell : space_.mesh().cells())
    {
      residual.fill(0.);
      matrix.fill(0.);
      std::array<Point2, 3> x;
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        x[a] = following ? space_.position(q, cell.nodes[a]) : space_.mesh().nodes()[cell.nodes[a]];
        for (unsigned int k = 0; k < 3; ++k)
          dofs[3 * a + k] = space_.dofs()[cell.nodes[a]][k];
      }
      cell_pressure(x, pressure, tangent, residual, matrix);
      target.add(dofs.data(), 3 * n_nodes, tangent ? matrix.data() : nullptr, residual.data());
    }
  }
} // namespace deltaform
