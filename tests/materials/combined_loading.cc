// Non-proportional loading of a perfectly plastic material against closed forms, with the order of convergence.
#include "material_point.h"

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double E = 210e3, nu = .3, G = E / (2. * (1. + nu)), Y = 240.;

  std::unique_ptr<Material> perfectly_plastic()
  {
    return make_material("elastoplastic",
                         "perfectly plastic",
                         {"Material/Young's modulus=" + std::to_string(E),
                          "Material/Poisson's ratio=" + std::to_string(nu),
                          "Material/Hardening/Flow stress=" + std::to_string(Y)});
  }

  /// Errors at 8, 16, ... steps: fall in the end with @p order, and come down to @p smallest.
  template <typename Error>
  void check_order(const Error &error, const double order, const double smallest)
  {
    double coarse = error(8);
    for (unsigned int n = 16; n <= 4096; n *= 2)
    {
      const double fine = error(n);
      const double measured = std::log2(coarse / fine);
      BOOST_TEST_MESSAGE(n << " steps: error " << fine << ", order " << measured);
      if (n >= 128)
        BOOST_TEST(std::abs(measured - order) < .05);
      coarse = fine;
    }
    BOOST_TEST(coarse < smallest);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(combined_loading)

/*
 * Thin-walled tube stretched to yield, then twisted at constant length, with neither hoop nor radial stress. On the
 * yield locus t11 = Y cos f, t12 = Y sin f / sqrt 3; from d e11 = 0 and the flow rule, for any Poisson's ratio,
 *
 *     gamma = Y / sqrt 3 ((1/G - 3/E) sin f + 3/E ln((1 + sin f) / cos f)),   e22 = e33 = -nu t11/E + (t11 - Y)/(2 E).
 *
 * For nu = 1/2 (3 G = E) this is t12 = Y / sqrt 3 tanh(sqrt 3 G gamma / Y). R. Hill, The Mathematical Theory of
 * Plasticity, Oxford 1950, chapter IV.
 */
BOOST_AUTO_TEST_CASE(tension_then_torsion)
{
  const auto material = perfectly_plastic();
  for (const auto third : {ThirdDirection::stress_given, ThirdDirection::strain_given})
    check_order(
      [&](const unsigned int n_steps) {
        MaterialPoint point(*material);
        double worst = 0.;
        for (unsigned int step = 0; step <= n_steps; ++step)
        {
          const double f = 1.4 * step / n_steps;
          const double t11 = Y * std::cos(f), t12 = Y * std::sin(f) / std::sqrt(3.);
          const double gamma =
            Y / std::sqrt(3.) * ((1. / G - 3. / E) * std::sin(f) + 3. / E * std::log((1. + std::sin(f)) / std::cos(f)));
          const double e22 = -nu * t11 / E + (t11 - Y) / (2. * E);
          Mandel strain{{Y / E, e22, e22, gamma / std::sqrt(2.)}}; // sqrt 2 e12, e12 = gamma / 2
          const Mandel stress = point.update(strain, third);
          const Mandel expected{{t11, 0., 0., std::sqrt(2.) * t12}};
          worst = std::max(worst, norm(difference(stress, expected)) / Y);
          worst = std::max(worst, std::abs(strain[2] - e22) * E / Y);
          point.commit();
        }
        return worst;
      },
      1.,
      1e-3);
}

/*
 * Constant rate of deviatoric strain from a point of the yield surface, outwards. The angle w between the deviator, of
 * constant length R = sqrt(2/3) Y, and the strain rate (measured strain s) follows tan(w/2) = tan(w0/2) exp(-2 G s /
 * R). R.D. Krieg, D.B. Krieg, Accuracies of numerical solution methods for the elastic-perfectly plastic model, J.
 * Press. Vess. Technol. 99 (1977) 510.
 */
BOOST_AUTO_TEST_CASE(constant_strain_rate)
{
  const auto material = perfectly_plastic();
  const double R = std::sqrt(2. / 3.) * Y;
  // Two orthogonal deviatoric directions of unit length, first along the stress
  const Mandel first{{2. / std::sqrt(6.), -1. / std::sqrt(6.), -1. / std::sqrt(6.), 0.}};
  const Mandel second{{0., .5, -.5, std::sqrt(.5)}};
  for (const double w0 : {.3, .9, 1.5})
  {
    Mandel direction;
    for (unsigned int i = 0; i < 4; ++i)
      direction[i] = std::cos(w0) * first[i] + std::sin(w0) * second[i];
    check_order(
      [&](const unsigned int n_steps) {
        MaterialPoint point(*material);
        double worst = 0.;
        for (unsigned int step = 0; step <= n_steps; ++step)
        {
          const double s = 3. * R / (2. * G) * step / n_steps;
          const double w = 2. * std::atan(std::tan(w0 / 2.) * std::exp(-2. * G * s / R));
          Mandel strain, expected;
          for (unsigned int i = 0; i < 4; ++i)
          {
            strain[i] = R / (2. * G) * first[i] + s * direction[i];
            // the stress stays in the plane of both directions, w away from the strain rate
            expected[i] = R * (std::cos(w0 - w) * first[i] + std::sin(w0 - w) * second[i]);
          }
          worst = std::max(worst, norm(difference(point.solid(strain), expected)) / R);
          point.commit();
        }
        return worst;
      },
      1.,
      1e-3);
  }
}

BOOST_AUTO_TEST_SUITE_END()
