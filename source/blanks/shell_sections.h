#pragma once

#include "shell_points.h"
#include "shell_space.h"

#include <deltaform/blanks/sheet_section.h>

#include <cmath>
#include <vector>

namespace deltaform
{
  /**
   * Cross-sections at the nodes of a shell, without what presses on them.
   * @param thickness of a node (length)
   * @param strain, stress along the meridian, of a layer of a quadrature point: logarithmic, Kirchhoff (stress)
   */
  template <typename Thickness, typename Strain, typename Stress>
  std::vector<SheetSection> shell_sections(const ShellSpace &space,
                                           const ShellPoints &points,
                                           const Thickness &thickness,
                                           const Strain &strain,
                                           const Stress &stress)
  {
    const unsigned int n = points.size();
    std::vector<double> strains(n, 0.), stresses(n, 0.);
    for (unsigned int p = 0, i = 0; p < n; ++p)
      for (unsigned int l = 0; l < points.n_layers(); ++l, ++i)
      {
        const double w = points.layer_weight(l) / points.thickness();
        strains[p] += w * strain(i);
        stresses[p] += w * stress(i);
      }
    strains = points.to_nodes(strains);
    stresses = points.to_nodes(stresses);
    std::vector<SheetSection> result(space.n_nodes());
    for (unsigned int i = 0; i < result.size(); ++i)
    {
      result[i].place = space.mesh().nodes()[i][0];
      result[i].arc = space.mesh().arc_length()[i];
      result[i].thickness = thickness(i);
      result[i].stretch = strains[i];
      result[i].thinning = -std::log(result[i].thickness / points.thickness());
      result[i].stress = stresses[i];
    }
    return result;
  }
} // namespace deltaform
