#include <deltaform/kinematics/logarithmic_strain.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    constexpr double root_2 = 1.41421356237309504880;

    /*
     * In the plane b = m 1 + S with the deviator S, d^2 = (S:S)/2, eigenvalues m +- d, det = m^2 - d^2:
     *     ln(b)/2 = ln(det)/4 1 + phi/2 S,   phi = atanh(d/m)/d,
     * an analytic function of m and d^2 also where the eigenvalues meet.
     */
    struct PlaneLogarithm
    {
      double s_1, s_2; ///< S = (s_1, s_2; s_2, -s_1)
      double m, determinant;
      double phi; ///< atanh(d/m)/d
      double phi_of_d2 = 0; ///< d phi / d(d^2)

      explicit PlaneLogarithm(const AxialTensor &b)
        : s_1(.5 * (b.xx - b.yy)), s_2(b.xy), m(.5 * (b.xx + b.yy)), determinant(b.xx * b.yy - b.xy * b.xy)
      {
        const double d2 = s_1 * s_1 + s_2 * s_2, x = d2 / (m * m);
        if (x < 1e-2)
        {
          // sum x^k/(2k+1) and sum (k+1)/(2k+3) x^k: eight terms leave 1e-17
          double sum = 0., derivative = 0.;
          for (int k = 8; k >= 0; --k)
          {
            sum = sum * x + 1. / (2 * k + 1);
            derivative = derivative * x + (k + 1.) / (2 * k + 3);
          }
          phi = sum / m;
          phi_of_d2 = derivative / (m * m * m);
        }
        else
        {
          const double d = std::sqrt(d2);
          phi = std::atanh(d / m) / d;
          phi_of_d2 = (m / determinant - phi) / (2. * d2);
        }
      }
    };
  } // namespace


  Mandel LogarithmicStrain::strain(const AxialTensor &b)
  {
    const PlaneLogarithm plane(b);
    const double mean = .25 * std::log(plane.determinant);
    return {{mean + .5 * plane.phi * plane.s_1,
             mean - .5 * plane.phi * plane.s_1,
             .5 * std::log(b.zz),
             root_2 * .5 * plane.phi * plane.s_2}};
  }


  LogarithmicStrain::Rate LogarithmicStrain::rate(const AxialTensor &b)
  {
    const PlaneLogarithm plane(b);
    // db of a unit velocity gradient 11, 12, 21, 22
    const double db_xx[4] = {2. * b.xx, 2. * b.xy, 0., 0.};
    const double db_yy[4] = {0., 0., 2. * b.xy, 2. * b.yy};
    const double db_xy[4] = {b.xy, b.yy, b.xx, b.xy};
    Rate result{};
    for (unsigned int k = 0; k < 4; ++k)
    {
      const double dm = .5 * (db_xx[k] + db_yy[k]), ds_1 = .5 * (db_xx[k] - db_yy[k]), ds_2 = db_xy[k];
      const double half_dd2 = plane.s_1 * ds_1 + plane.s_2 * ds_2;
      const double dmean = .5 * (plane.m * dm - half_dd2) / plane.determinant;
      const double dphi = -dm / plane.determinant + 2. * plane.phi_of_d2 * half_dd2;
      const double de_1 = .5 * (dphi * plane.s_1 + plane.phi * ds_1);
      result[0][k] = dmean + de_1;
      result[1][k] = dmean - de_1;
      result[3][k] = root_2 * .5 * (dphi * plane.s_2 + plane.phi * ds_2);
    }
    result[2][4] = 1.;
    return result;
  }


  AxialTensor LogarithmicStrain::inverse(const Mandel &e)
  {
    // exp(2 m 1 + S) = exp(2 m) (cosh(d) 1 + sinh(d)/d S)
    const double s_1 = e[0] - e[1], s_2 = root_2 * e[3], d2 = s_1 * s_1 + s_2 * s_2;
    double cosh = 0., sinh_over_d = 0.;
    if (d2 < 1e-4)
    {
      // Elastic strains of metals: sum d^2k/(2k)! and sum d^2k/(2k+1)!, four terms leave 1e-20.
      const double d4 = d2 * d2;
      cosh = 1. + d2 * (1. / 2) + d4 * (1. / 24 + d2 * (1. / 720));
      sinh_over_d = 1. + d2 * (1. / 6) + d4 * (1. / 120 + d2 * (1. / 5040));
    }
    else
    {
      const double d = std::sqrt(d2);
      cosh = std::cosh(d);
      sinh_over_d = std::sinh(d) / d;
    }
    const double size = std::exp(e[0] + e[1]), even = size * cosh, odd = size * sinh_over_d;
    return {even + odd * s_1, even - odd * s_1, std::exp(2. * e[2]), odd * s_2};
  }
} // namespace deltaform
