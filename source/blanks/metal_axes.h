#pragma once

#include <deltaform/materials/material.h>

#include <cmath>

namespace deltaform
{
  /**
   * The axes 1 and 2 of a point of metal in the plane of r and z, turned by an angle; axis 3 never turns. Tensors are
   * in Mandel's components, of which a rotation is an orthogonal matrix.
   */
  class MetalAxes
  {
  public:
    MetalAxes() = default;

    /// Axis 1 along the direction (@p cosine, @p sine), of any length.
    MetalAxes(const double cosine, const double sine)
    {
      const double inverse = 1. / (cosine * cosine + sine * sine);
      cosine_ = inverse * (cosine * cosine - sine * sine);
      sine_ = inverse * 2. * cosine * sine;
    }

    /// A tensor of r and z in these axes.
    Mandel into(const Mandel &t) const
    {
      return turned(t, -sine_);
    }

    /// A tensor of these axes in r and z.
    Mandel out_of(const Mandel &t) const
    {
      return turned(t, sine_);
    }

    /// The same for moduli (4 x 4, row-major).
    void turn_out(double *moduli) const
    {
      for (unsigned int i = 0; i < 4; ++i)
        set_row(moduli, 4, i, out_of(row(moduli, 4, i)));
      for (unsigned int j = 0; j < 4; ++j)
        set_row(moduli, 1, j, out_of(row(moduli, 1, j)));
    }

    /// Rate of a tensor that turns with an angular velocity of 1.
    static Mandel spin(const Mandel &t)
    {
      const double root_2 = std::sqrt(2.);
      return {{-root_2 * t[3], root_2 * t[3], 0., root_2 * (t[0] - t[1])}};
    }

  private:
    Mandel turned(const Mandel &t, const double sine) const
    {
      const double root_2 = std::sqrt(2.);
      const double mean = .5 * (t[0] + t[1]), half = .5 * (t[0] - t[1]), shear = t[3] / root_2;
      const double along = half * cosine_ - shear * sine;
      return {{mean + along, mean - along, t[2], root_2 * (half * sine + shear * cosine_)}};
    }

    /// Row @p k (stride 4) or column (stride 1) of moduli.
    static Mandel row(const double *moduli, const unsigned int stride, const unsigned int k)
    {
      const double *const first = moduli + stride * k;
      const unsigned int next = 5 - stride;
      return {{first[0], first[next], first[2 * next], first[3 * next]}};
    }

    static void set_row(double *moduli, const unsigned int stride, const unsigned int k, const Mandel &values)
    {
      for (unsigned int i = 0; i < 4; ++i)
        moduli[stride * k + (5 - stride) * i] = values[i];
    }

    double cosine_ = 1., sine_ = 0.; ///< of twice the angle
  };
} // namespace deltaform
