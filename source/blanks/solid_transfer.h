#pragma once

#include "material_points.h"
#include "solid_discretization.h"
#include "solid_kernel.h"
#include "solid_motion.h"

#include <vector>

namespace deltaform
{
  /**
   * What a refined mesh of a solid knows of the old one: places, displacements and the plastic state of the points,
   * cell by cell (doc/theory/solid.md). First divide_cells(), then the discretization is set up anew with place(), then
   * take_over().
   */
  class SolidTransfer
  {
  public:
    /// All that a cell knows: places of its nodes, their values in every field, plastic state of its points.
    using CellData = std::vector<double>;

    SolidTransfer(SolidDiscretization &body, MaterialPoints &material, SolidMotion &motion, SolidKernel &kernel)
      : body_(body), material_(material), motion_(motion), kernel_(kernel)
    {
    }

    /// Halve the cells that are flagged for it, share all among the processes anew and hand on what the cells know.
    /// @param fields values of the unknowns
    void divide_cells(const std::vector<Vector> &fields);

    /// Of a node of an own cell in the undeformed body.
    Point2 place(const unsigned int cell, const unsigned int node) const
    {
      return {cells_[cell][2 * node], cells_[cell][2 * node + 1]};
    }

    /// Bring @p fields and the state of all points to the new mesh.
    void take_over(std::vector<Vector> &fields);

  private:
    CellData pack(unsigned int cell, const std::vector<Vector> &fields) const;
    CellData child_of(const CellData &parent, unsigned int child) const;
    void interpolate_nodes(const CellData &parent, unsigned int child, std::size_t n_vectors, CellData &result) const;
    void interpolate_points(const double *parent, unsigned int child, double *result) const;
    Vector unpack_field(unsigned int field) const;
    void unpack_points(std::size_t n_fields);

    /// Numbers that are carried over of a point.
    std::size_t n_state() const;

    /// What the points of the parent said of a point: history, plastic metric, elastic strain, volume offset,
    /// criteria.
    const double *state_of(unsigned int point, std::size_t n_fields) const;

    /// Make the elastic strains of all points, at the displacements of the last pass, those of the parents as far as
    /// metal has flowed there: by the plastic strain and, for the volume, by the volume offset.
    void keep_elastic_strain(const std::vector<Mandel> &wanted);

    SolidDiscretization &body_;
    MaterialPoints &material_;
    SolidMotion &motion_;
    SolidKernel &kernel_;
    std::vector<CellData> cells_; ///< of the own cells, between divide_cells() and take_over()
  };
} // namespace deltaform
