#pragma once

#include "cell_cut.h"
#include "material_points.h"
#include "solid_discretization.h"
#include "solid_kernel.h"
#include "solid_motion.h"

#include <deltaform/io/keyed_arrays.h>

#include <vector>

namespace deltaform
{
  /**
   * The state of a solid goes from one discretization to another: places, displacements and the plastic state of the
   * points, cell by cell (doc/theory/solid.md). What the new cells know is cut out of the old ones. Those of a refined
   * mesh are quarters of cells: first divide_cells(), then the discretization is set up anew with place(). Those of a
   * mesh that begins with an earlier operation lie anywhere in the body: cut_cells() finds where. Both end with
   * take_over().
   */
  class SolidTransfer
  {
  public:
    using CellData = CellCut::Data;

    SolidTransfer(SolidDiscretization &body, MaterialPoints &material, SolidMotion &motion, SolidKernel &kernel)
      : body_(body), material_(material), motion_(motion), kernel_(kernel)
    {
    }

    /// Halve the cells that are flagged for it, share all among the processes anew and hand on what the cells know.
    /// @param fields values of the unknowns
    void divide_cells(const std::vector<Vector> &fields);

    /// Put the cells of all processes, with the displacements @p q, into a state for cut_cells().
    void describe(const Vector &q, KeyedArrays &formed) const;

    /// Cut the cells of the mesh as it is out of those that were described.
    /// @throws SceneError if the mesh is no part of that body, or the points there knew other numbers
    void cut_cells(const KeyedArrays &formed);

    /// Is a state that was described one of cells of the same degree, whose points know the same numbers?
    bool same_kind(const KeyedArrays &formed) const;

    /// Of a node of an own cell in the undeformed body.
    Point2 place(const unsigned int cell, const unsigned int node) const
    {
      return {cells_[cell][2 * node], cells_[cell][2 * node + 1]};
    }

    /// Bring @p fields and the state of all points to the new mesh.
    void take_over(std::vector<Vector> &fields);

  private:
    CellData pack(unsigned int cell, const std::vector<Vector> &fields) const;
    std::vector<CellData> pack_all(const std::vector<Vector> &fields) const;
    CellData child_of(const CellCut &cutter, const CellData &parent, unsigned int child) const;
    CellData part_of(const CellSearch &old, const CellCut &cutter, unsigned int cell) const;
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
    std::vector<CellData> cells_; ///< of the own cells, before take_over()
  };
} // namespace deltaform
