#pragma once

#include "material_points.h"

#include <array>

namespace deltaform
{
  /// The metal of a shell as if it had no history: a strain reached in one increment from none.
  class VirginMetal
  {
  public:
    using Moduli = std::array<double, 16>; ///< 4 x 4, condensed for the third stress

    struct Answer
    {
      double flow; ///< equivalent plastic strain
      Mandel stress, plastic; ///< Kirchhoff stress; plastic strain
      Moduli moduli;
    };

    explicit VirginMetal(const MaterialPoints &material)
      : material_(material)
    {
    }

    /// @param strain logarithmic @param third_stress Kirchhoff stress through the thickness
    Status evaluate(Mandel strain, double third_stress, Answer &answer) const;

  private:
    const MaterialPoints &material_;
  };
} // namespace deltaform
