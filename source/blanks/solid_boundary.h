#pragma once

#include "solid_edge.h"
#include "solid_space.h"

#include <deltaform/base/assembly_target.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /// The boundary of a solid by its named parts, known to all processes, and what loads on it.
  class SolidBoundary
  {
  public:
    explicit SolidBoundary(const SolidSpace &space)
      : space_(space)
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

    /// The share of every one of nodes() in the initial area.
    std::vector<double> weights(const std::string &part) const;

    /// See Blank::assemble_pressure(); @p following: on the current area.
    void assemble_pressure(const Vector &q,
                           const std::string &part,
                           double pressure,
                           bool following,
                           AssemblyTarget &target) const;

    /// The own cell with an edge between two nodes of the boundary; invalid_index if another process has it.
    unsigned int cell(unsigned int a, unsigned int b) const;

    /// Strip: bottom and top node of every station where both sides have one.
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
    std::map<std::string, std::vector<Edge>> edges_;
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> cells_; ///< by the ends of their edges
    std::vector<std::array<unsigned int, 2>> columns_;
  };
} // namespace deltaform
