#pragma once

#include <deltaform/materials/material.h>
#include <deltaform/parameters/registry.h>

#include <string>

namespace deltaform
{
  /// What happened at a point in an accepted increment. Tensors are Mandel, in axes whose third one is principal.
  struct PointStep
  {
    Mandel stress_before, stress; ///< Kirchhoff stress at its begin and end (stress)
    Mandel flow; ///< growth of the plastic strain (1)
    double equivalent; ///< growth of the equivalent plastic strain (1)
    double warming = 0.; ///< growth of the temperature, of a metal that counts it (temperature)
  };

  /**
   * A number that grows at the points of a blank with the flow of the metal and on which nothing depends: damage, use
   * of a forming limit. It begins at zero.
   */
  class PointField
  {
  public:
    virtual ~PointField() = default;

    /// What a cross-section of a sheet reports of its points.
    enum class Across : unsigned char
    {
      largest, ///< the largest value: metal cracks where it is worst
      mean, ///< over the thickness
      middle ///< the value half way between the faces: necks do not see bending
    };

    virtual Across across() const
    {
      return Across::largest;
    }

    /// Dimension: "1", "stress".
    virtual std::string unit() const
    {
      return "1";
    }

    /// Growth in an increment.
    virtual double growth(const PointStep &step) const = 0;
  };

  /// What a point field may know of its blank.
  struct PointFieldHost
  {
    const Material &law;
    bool sheet; ///< axes 1 and 2 of its points lie in the plane of a sheet
  };

  /// Point fields by name; a name is also that of the field's section in Limits, and, with underscores, of its columns.
  using PointFields = Registry<PointField, const PointFieldHost &>;

  /// Does the metal count its temperature, and does the heat of its flow stay where it is made?
  bool keeps_its_heat(const Material &law);

  /// Largest principal stress (stress).
  double largest_principal(const Mandel &stress);

  /// Mean stress over Mises stress (1); zero without stress.
  double triaxiality(const Mandel &stress);
} // namespace deltaform
