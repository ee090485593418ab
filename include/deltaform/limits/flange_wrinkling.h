#pragma once

#include <deltaform/blanks/blank.h>
#include <deltaform/contact/contact_interface.h>
#include <deltaform/io/table.h>
#include <deltaform/limits/annular_plate.h>
#include <deltaform/limits/limit.h>
#include <deltaform/materials/uniaxial_curve.h>

#include <memory>
#include <optional>
#include <vector>

namespace deltaform
{
  /**
   * Does the flange of an axisymmetric shell wrinkle? The flange is what lies flat (inclined by less than a tenth) from
   * the rim inwards, hinged where it leaves the die. It is asked for waves under its present stresses (wrinkle()), with
   * the bending stiffness E0 t^3/12/(1 - nu^2) of the reduced modulus E0 = 4 E Et/(sqrt E + sqrt Et)^2, Et that of
   * uniaxial tension at the present plastic strain. It only reads.
   */
  class FlangeWrinkling
  {
  public:
    struct Result
    {
      Wrinkles wrinkles;
      double holder_pressure = 0.; ///< mean normal contact stress on the top of the flange

      /// Do waves grow although a holder presses?
      bool wrinkles_now() const
      {
        return wrinkles.factor < 1. && holder_pressure < wrinkles.pressure;
      }
    };

    /// Read what the scene asks for; null if it does not. @throws SceneError if the blank has no flange
    static std::unique_ptr<FlangeWrinkling> read(const Section &scene, const Blank &blank);

    Limit::Then then() const
    {
      return then_;
    }

    /// Of a shell with the @p profile, between the tools of @p interfaces.
    Result judge(const Table &profile, const std::vector<ContactInterface *> &interfaces) const;

    /// What of a profile lies flat, from its inner edge to the rim; empty: nothing.
    std::vector<RingPoint> flange(const Table &profile) const;

  private:
    FlangeWrinkling() = default;

    Limit::Then then_ = Limit::Then::warn;
    double height_ = 0.; ///< of waves that are allowed
    double young_modulus_ = 0., poisson_ratio_ = 0.;
    std::vector<UniaxialPoint> curve_; ///< empty: the metal is elastic
  };
} // namespace deltaform
