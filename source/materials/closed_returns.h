#pragma once

#include <deltaform/materials/return_map.h>

namespace deltaform
{
  /// Mises, isotropic hardening, all strains given.
  class RadialReturn final : public ReturnMap
  {
  public:
    PointOutcome update(const FlowLaw &law, const PointUpdate &point) const override;
  };


  /// Mises, isotropic hardening, in-plane strains and third stress given.
  class PlaneStressReturn final : public ReturnMap
  {
  public:
    PointOutcome update(const FlowLaw &law, const PointUpdate &point) const override;
  };


  /// The same for Hill 1948 with normal anisotropy, direction 3 normal to the sheet.
  class NormalAnisotropyReturn final : public ReturnMap
  {
  public:
    /// @p r > -1/2
    explicit NormalAnisotropyReturn(const double r)
      : r_(r)
    {
    }

    PointOutcome update(const FlowLaw &law, const PointUpdate &point) const override;

  private:
    double r_;
  };
} // namespace deltaform
