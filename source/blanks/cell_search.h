#pragma once

#include <deltaform/assembly/types.h>

#include <deal.II/fe/fe_q.h>

#include <array>
#include <vector>

namespace deltaform
{
  /// A place in the undeformed body: a cell, and where in its unit cell.
  struct CellPlace
  {
    const std::vector<double> *cell; ///< what it knows; first, the undeformed places of its nodes
    Point2 xi;
  };


  /// Finds points of the undeformed body in cells of a solid that need not be those of its mesh.
  class CellSearch
  {
  public:
    /// @param degree of the shape functions
    /// @param cells each begins with the undeformed places of its nodes, in the order of the shape functions
    CellSearch(unsigned int degree, std::vector<std::vector<double>> cells);

    /// The place that is nearest to the point @p X. @param distance out: how far it is away; 0 within a cell
    CellPlace find(const Point2 &X, double &distance) const;

    const std::vector<std::vector<double>> &cells() const
    {
      return cells_;
    }

    double shape(const unsigned int node, const Point2 &xi) const
    {
      return shapes_.shape_value(node, xi);
    }

  private:
    using Box = std::array<Point2, 2>; ///< corners

    Box box_around(const std::vector<double> &cell) const;

    /// Where @p X lies in a cell, or the nearest place of its unit cell.
    Point2 unit_place(const std::vector<double> &cell, const Point2 &X) const;
    Point2 place(const std::vector<double> &cell, const Point2 &xi) const;

    dealii::FE_Q<2> shapes_;
    unsigned int n_nodes_;
    std::vector<std::vector<double>> cells_;
    std::vector<Box> boxes_; ///< around the nodes of every cell
  };
} // namespace deltaform
