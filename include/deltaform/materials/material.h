#pragma once

#include <deltaform/assembly/status.h>
#include <deltaform/kinematics/mandel.h>
#include <deltaform/materials/history_layout.h>
#include <deltaform/materials/metal_heat.h>

#include <limits>
#include <optional>

namespace deltaform
{
  /// What is asked of the third direction.
  enum class ThirdDirection : unsigned char
  {
    strain_given, ///< strain[p][2] is input: solid, plane strain or axisymmetric
    stress_given ///< third_stress[p] is input, strain[p][2] is output: shells (plane stress)
  };

  /// Rotations of the axes under which a law gives the same answer.
  enum class Symmetry : unsigned char
  {
    orthotropic, ///< none
    about_third_axis, ///< in the plane of directions 1 and 2: a sheet with normal anisotropy
    isotropic ///< any
  };

  /// What the axes 1, 2, 3 of a point are. The shear acts in the plane of 1 and 2.
  enum class PointAxes : unsigned char
  {
    sheet, ///< meridional, hoop, normal to the sheet: shells, and isotropic laws anyway
    section ///< meridional, normal to the sheet, hoop: the section of a solid
  };

  /// What a law is and can be used for. Blanks refuse a law that they cannot serve, tests ask no more than this.
  struct MaterialTraits
  {
    Symmetry symmetry = Symmetry::isotropic;
    bool symmetric_tangent = true;
    bool isotropic_hardening = true; ///< stress times increment of plastic strain is flow stress times increment of the
      ///< equivalent plastic strain
    bool needs_duration = false; ///< MaterialBatch::duration
    bool strain_given = true, stress_given = true; ///< what may be given of the third direction
    bool section = true; ///< can it be used in the axes of a solid's section (PointAxes)?
  };

  /**
   * All points of one cell. Arrays have n_points entries; history has n_points * Material::history_size() values,
   * point by point. Stress is the Kirchhoff stress, strain the total logarithmic strain. Axes of their components:
   * shell 1 meridional, 2 hoop, 3 normal; solid 1 r, 2 z, 3 hoop, or, of a law with axes, as PointAxes says.
   */
  struct MaterialBatch
  {
    unsigned int n_points = 0;
    ThirdDirection third_direction = ThirdDirection::strain_given;
    Mandel *strain = nullptr; ///< in; [2] out for stress_given
    const double *third_stress = nullptr; ///< in for stress_given: Kirchhoff stress along direction 3
    const double *committed = nullptr; ///< in: history at the last accepted increment
    const Mandel *committed_stress = nullptr; ///< in, or null: Kirchhoff stress at the last accepted increment
    double duration = 0.; ///< in: time that the increment takes (time), for laws that need it
    double duration_share = 1.; ///< in: share of it that counts for flow from the predicted history (Bdf2Predictor)
    double *predictor = nullptr; ///< in, or null: what a law of two steps adds to the committed history before the flow
      ///< of this increment (Bdf2Predictor); out: zero where the flow did not go on
    double *trial = nullptr; ///< in: a starting guess from the last iteration; out: history at this strain
    Mandel *stress = nullptr; ///< out
    double *tangent = nullptr; ///< out if not null: n_points x 4 x 4 row-major, d stress / d strain. For
      ///< stress_given it is condensed: row and column [2] are zero.
  };

  /**
   * A stress-strain law in logarithmic strain and Kirchhoff stress, evaluated for all points of a cell at once. It has
   * no mutable state: the history lives with the blank, as two flat arrays (committed, trial).
   */
  class Material
  {
  public:
    virtual ~Material() = default;

    /// What the law remembers at a point; all values start at zero. No fields: the law is elastic.
    virtual const HistoryLayout &history_layout() const = 0;

    /// Values of history per point.
    unsigned int history_size() const
    {
      return history_layout().size();
    }

    virtual MaterialTraits traits() const
    {
      return {};
    }

    /// In which axes strains and stresses will be; before any update(). As long as nobody says so, those of the sheet.
    virtual void set_axes(PointAxes)
    {
    }

    /// Does the law want MaterialBatch::predictor?
    virtual bool two_steps() const
    {
      return false;
    }

    /// Nothing: heat stays where it is made, or is not counted.
    virtual std::optional<MetalHeat> heat() const
    {
      return std::nullopt;
    }

    /// Stress, tangent and trial history of all points.
    virtual Status update(const MaterialBatch &batch) const = 0;

    /// Elastic part of the logarithmic strain (1) of a state with Kirchhoff stress @p stress.
    virtual Mandel elastic_strain(const Mandel &stress) const = 0;

    /// Elastic energy per reference volume of a state with Kirchhoff stress @p stress.
    virtual double elastic_energy(const Mandel &stress) const = 0;

    /// The same of a point with @p history, on which the elasticity may depend.
    virtual double stored_energy(const Mandel &stress, const double * /*history*/) const
    {
      return elastic_energy(stress);
    }

    /// Plastic strain (3x3, Mandel) of one point's history; zero for elastic laws.
    virtual Mandel plastic_strain(const double *history) const = 0;

    /// Equivalent plastic strain of one point's history; zero for elastic laws.
    virtual double equivalent_plastic_strain(const double *history) const = 0;

    /// Kirchhoff stress at which one point's history flows in uniaxial tension; infinite for elastic laws.
    virtual double flow_stress(const double * /*history*/) const
    {
      return std::numeric_limits<double>::infinity();
    }

    /// Shear modulus for transverse shear and stiffness estimates; Young's modulus; Poisson's ratio.
    virtual double shear_modulus() const = 0;
    virtual double young_modulus() const = 0;
    virtual double poisson_ratio() const = 0;
  };
} // namespace deltaform
