#pragma once

#include "solid_edge.h"
#include "solid_points.h"
#include "solid_space.h"

#include <deltaform/blanks/boundary.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /// The boundary of a solid by its named parts, known to all processes, and what loads on it.
  class SolidBoundary : public Boundary
  {
  public:
    /// @p moves: following pressures act on the current area; if not, on the initial one
    SolidBoundary(const SolidSpace &space, const SolidPoints &points, const bool moves)
      : space_(space), points_(points), moves_(moves)
    {
    }

    /// Collect the edges of the cells as they are now.
    void set_up();

    bool has(const std::string &part) const
    {
      return edges_.count(part) > 0;
    }

    /// @throws std::invalid_argument if there is no such part; so do all that ask for one
    const std::vector<Edge> &edges(const std::string &part) const;

    /// Nodes of a part, ascending.
    std::vector<unsigned int> nodes(const std::string &part) const;

    std::vector<std::string> parts() const override;
    std::vector<DofIndex> dofs(const std::string &part, Component component) const override;
    std::vector<Point2> points(const std::string &part) const override;
    std::vector<double> weights(const std::string &part) const override;
    std::vector<std::string> faces() const override;
    std::vector<unsigned int> face_nodes(const std::string &face) const override;
    void assemble_pressure(const Vector &q,
                           const std::string &face,
                           double pressure,
                           bool following,
                           AssemblyTarget &target) const override;
    std::vector<std::pair<DofIndex, double>> volume_weights(Component component) const override;
    std::vector<std::vector<LineNode>> lines() const override;

    /// The own cell with an edge between two nodes of the boundary; invalid_index if another process has it.
    unsigned int cell(unsigned int a, unsigned int b) const;

    /// Strip: bottom and top node of every cross-section where both sides have one.
    const std::vector<std::array<unsigned int, 2>> &columns() const
    {
      return columns_;
    }

  private:
    using Matrix = std::array<double, 36>;

    /// Forces of a pressure on one edge with its nodes at @p x, and if @p tangent their derivatives.
    void edge_pressure(const std::array<Point2, 3> &x,
                       double pressure,
                       bool tangent,
                       std::array<double, 6> &residual,
                       Matrix &matrix) const;

    void set_up_columns();

    const SolidSpace &space_;
    const SolidPoints &points_;
    bool moves_;
    std::map<std::string, std::vector<Edge>> edges_;
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> cells_; ///< by the ends of their edges
    std::vector<std::array<unsigned int, 2>> columns_;
  };
} // namespace deltaform
