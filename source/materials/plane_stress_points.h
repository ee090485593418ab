#pragma once

#include <deltaform/materials/material.h>

#include <vector>

namespace deltaform
{
  /// Points of a law in plane stress, without a blank: led from strain to strain, each increment of duration 1.
  class PlaneStressPoints
  {
  public:
    explicit PlaneStressPoints(const Material &law, unsigned int n = 1);

    /// Total logarithmic strain of the next update(): [0], [1] and [3] are to be set, [2] comes out.
    Mandel &strain(const unsigned int point = 0)
    {
      return strain_[point];
    }

    /// @return does the law give stresses at these strains?
    bool update();

    /// The next update() starts from the last one.
    void accept();

    const Mandel &accepted_strain(const unsigned int point = 0) const
    {
      return accepted_strain_[point];
    }

    /// Kirchhoff stress of the last update().
    const Mandel &stress(const unsigned int point = 0) const
    {
      return stress_[point];
    }

    /// d stress/d strain of the last update(), 4 x 4, row-major; row and column [2] are zero.
    const double *tangent(const unsigned int point = 0) const
    {
      return &tangent_[16 * point];
    }

    /// Accepted.
    double equivalent_plastic_strain(unsigned int point = 0) const;

  private:
    const Material &law_;
    std::vector<Mandel> strain_, accepted_strain_, stress_;
    std::vector<double> tangent_, no_stress_, committed_, trial_;
  };
} // namespace deltaform
