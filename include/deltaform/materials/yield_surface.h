#pragma once

#include <deltaform/materials/material.h>
#include <deltaform/materials/return_map.h>

#include <array>
#include <memory>
#include <string>

namespace deltaform
{
  /// The equivalent stress at a stress, with its derivatives.
  struct YieldPoint
  {
    double value; ///< q (stress)
    Mandel gradient; ///< dq/d stress: direction of flow
    std::array<double, 16> hessian; ///< d2q/d stress^2, 4 x 4, row-major (1/stress)
  };


  /**
   * A yield surface q(stress) = flow stress with associated flow. The equivalent stress q is convex, homogeneous of
   * degree one (q(a t) = a q(t) for a >= 0), not negative, does not depend on the pressure, and is the stress itself
   * in uniaxial tension along one direction, which the law names (that of the flow curve); the increment of the
   * equivalent plastic strain is then work-conjugate to it. Kirchhoff stress less the backstress, in Mandel's
   * components and the axes of the point (Mandel).
   *
   * All that a surface has to give is evaluate(): the general return map does the rest, for solids and for shells.
   */
  class YieldSurface
  {
  public:
    virtual ~YieldSurface() = default;

    /// @p stress is not a pressure: q > 0.
    virtual YieldPoint evaluate(const Mandel &stress) const = 0;

    /// q alone, of any stress.
    virtual double equivalent_stress(const Mandel &stress) const = 0;

    virtual Symmetry symmetry() const
    {
      return Symmetry::orthotropic;
    }

    /// The same surface in the axes of a solid's section (PointAxes); null if it is isotropic, or not defined there.
    virtual std::unique_ptr<YieldSurface> in_section() const
    {
      return nullptr;
    }

    /// Can it be evaluated with this given of the third direction? A surface of plane stress cannot be with
    /// strain_given: its metal is for shells only.
    virtual bool serves(ThirdDirection) const
    {
      return true;
    }

    /// P of a surface q^2 = t . P t, 4 x 4, row-major (1), for which a pressure is in the null space; null: it is none.
    virtual const std::array<double, 16> *quadratic_form() const
    {
      return nullptr;
    }

    /// A return map in closed form, for the metal without backstress and rate factor; null: the general one.
    virtual const ReturnMap *closed_form(ThirdDirection) const
    {
      return nullptr;
    }
  };
} // namespace deltaform
