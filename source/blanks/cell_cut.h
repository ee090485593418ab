#pragma once

#include "cell_search.h"

#include <deltaform/materials/material.h>

#include <cstddef>
#include <vector>

namespace deltaform
{
  /**
   * Makes a cell of a solid of what others know: of its nodes by their shape functions, of its points by the
   * polynomials of the history (doc/theory/solid.md, "Transfer"). A quarter of a cell and a cell of another mesh on the
   * same undeformed body differ only in where their nodes and points lie in the old cells.
   */
  class CellCut
  {
  public:
    /// All that a cell knows: undeformed places of its nodes, their values in every field (two numbers a node each);
    /// then the state of its points, the history of the law first.
    using Data = std::vector<double>;

    /// @param degree of the shape functions of the old cells
    /// @param n_state numbers of a point
    CellCut(unsigned int degree, std::size_t n_state, const Material &law);

    /// A cell with its nodes and points at these places.
    /// @param margin least distance of a point from the edges of an old cell (of its length); 0: points lie anywhere
    Data cut(const std::vector<CellPlace> &nodes, const std::vector<CellPlace> &points, double margin) const;

    /// Of a cell, in the order of its shape functions.
    const std::vector<Point2> &unit_nodes() const
    {
      return shapes_.get_unit_support_points();
    }

  private:
    void add_nodes(const std::vector<CellPlace> &nodes, Data &result) const;
    void add_state(const CellPlace &place, double margin, Data &result) const;

    dealii::FE_Q<2> shapes_;
    unsigned int n_nodes_;
    std::size_t n_state_;
    const Material &law_;
    std::vector<Point2> unit_points_;
  };
} // namespace deltaform
