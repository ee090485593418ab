#pragma once

#include "material_points.h"
#include "solid_discretization.h"
#include "solid_motion.h"

#include <deltaform/blanks/conducting.h>

#include <vector>

namespace deltaform
{
  /// Heat in the cells of a solid: shape functions and points are those of the displacements (doc/theory/heat.md).
  class SolidHeat : public Conducting
  {
  public:
    /// @p material conducts
    SolidHeat(const SolidDiscretization &body, MaterialPoints &material, const SolidMotion &motion);

    const MetalHeat &metal() const override
    {
      return metal_;
    }

    DofIndex place_of(unsigned int node) const override;
    std::vector<double> at_nodes(const Vector &rise) const override;
    void assemble(const Vector &q, const Vector &rise, double duration, AssemblyTarget &target) const override;
    double heat_of_flow(const Vector &rise) const override;
    double stored_heat() const override;
    void give(const Vector &rise) override;
    std::vector<FilmEdge> edges(const Vector &q, const std::string &part) const override;

  private:
    /// Of the accepted state.
    double rise(const std::size_t point) const
    {
      return material_.history(point)[field_.first];
    }

    /// Between the nodes; @p values with those of hanging nodes.
    double interpolate(const Vector &values, unsigned int point) const;

    /// Gradients of the shape functions at a point in the body as it is now, and the volume that it stands for.
    struct CurrentPoint
    {
      std::vector<Tensor1> gradients;
      double volume;
    };
    CurrentPoint current(const Vector &q, unsigned int cell, unsigned int point) const;

    const SolidDiscretization &body_;
    MaterialPoints &material_;
    const SolidMotion &motion_;
    MetalHeat metal_;
    HistoryField field_; ///< of the history: the rise of the temperature
  };
} // namespace deltaform
