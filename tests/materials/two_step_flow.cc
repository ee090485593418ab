// The two-step formula of flow: order, tangent, and what it does where flow ends.
#include "material_point.h"

#include <deltaform/materials/bdf2_predictor.h>
#include <deltaform/materials/flow_error.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

namespace
{
  constexpr double young = 200e3, poisson = .3, flow_stress = 300.;
  const double shear = young / (2. * (1. + poisson));
  const double radius = std::sqrt(2. / 3.) * flow_stress; // of the yield surface, |s|

  /// Elastic, perfectly plastic.
  std::unique_ptr<Material> make(const std::string &integration, const std::string &law = "perfectly plastic")
  {
    std::vector<std::string> entries{
      "Material/Young's modulus=200e3", "Material/Poisson's ratio=0.3", "Material/Integration=" + integration};
    if (law == "perfectly plastic")
      entries.push_back("Material/Hardening/Flow stress=300");
    return testing::make_material("elastoplastic", law, entries);
  }

  /// One point that goes on from increment to increment.
  struct Path
  {
    explicit Path(const Material &law)
      : material(law), history(1, law.history_layout()),
        predictor(law.two_steps() ? Bdf2Predictor(1, law.history_size()) : Bdf2Predictor())
    {
    }

    Mandel update(Mandel strain, const ThirdDirection third = ThirdDirection::strain_given, double *tangent = nullptr)
    {
      Mandel stress{};
      const double third_stress = 0.;
      MaterialBatch batch;
      batch.n_points = 1;
      batch.third_direction = third;
      batch.strain = &strain;
      batch.third_stress = &third_stress;
      batch.committed = history.committed(0);
      batch.predictor = predictor.at(0);
      batch.trial = history.trial(0);
      batch.stress = &stress;
      batch.tangent = tangent;
      BOOST_TEST(material.update(batch).good());
      return stress;
    }

    void commit()
    {
      predictor.keep(history);
      history.commit();
    }

    const Material &material;
    PointHistory history;
    Bdf2Predictor predictor;
  };

  // Two directions of strain without change of volume, of length 1, at right angles.
  const Mandel along{{std::sqrt(2. / 3.), -std::sqrt(1. / 6.), -std::sqrt(1. / 6.), 0.}};
  const Mandel across{{0., 0., 0., 1.}};

  Mandel combined(const double a, const double b)
  {
    Mandel e;
    for (unsigned int k = 0; k < 4; ++k)
      e[k] = a * along[k] + b * across[k];
    return e;
  }

  /**
   * Strained along one direction to the yield surface, then by @p beyond at right angles to it: the stress turns by
   * tan(psi/2) = tan(psi_0/2) exp(-2 G e/R) towards the strain rate. R.D. Krieg, D.B. Krieg, Accuracies of numerical
   * solution methods for the elastic-perfectly plastic model, J. Pressure Vessel Technol. 99 (1977) 510.
   * @return error of the angle psi
   */
  double error(const std::string &integration, const unsigned int n, const double beyond)
  {
    const auto material = make(integration);
    Path path(*material);
    const double yield = radius / (2. * shear);
    path.update(combined(yield, 0.));
    path.commit();
    Mandel stress{};
    for (unsigned int i = 1; i <= n; ++i)
    {
      path.predictor.predict(i > 1 ? 1. : 0.);
      stress = path.update(combined(yield, beyond * i / n));
      path.commit();
    }
    double s_along = 0., s_across = 0.;
    for (unsigned int k = 0; k < 4; ++k)
    {
      s_along += stress[k] * along[k];
      s_across += stress[k] * across[k];
    }
    BOOST_TEST(std::hypot(s_along, s_across) == radius, boost::test_tools::tolerance(1e-9));
    const double exact = 2. * std::atan(std::exp(-2. * shear * beyond / radius));
    return std::abs(std::atan2(s_along, s_across) - exact);
  }

  void check_tangent(const ThirdDirection third)
  {
    const auto material = make("two steps", "swift");
    Path path(*material);
    for (unsigned int i = 1; i <= 3; ++i)
    {
      path.predictor.predict(i > 1 ? 1. : 0.);
      path.update({{.004 * i, .001 * i * i, -.003 * i, .002 * i}}, third);
      path.commit();
    }
    path.predictor.predict(1.5);
    const Mandel strain{{.018, .0245, -.02, .014}};
    std::array<double, 16> tangent;
    path.update(strain, third, tangent.data());
    BOOST_TEST(path.history.trial(0)[4] > path.history.committed(0)[4] + path.predictor.at(0)[4]);
    for (unsigned int j = 0; j < 4; ++j)
    {
      if (j == 2 && third == ThirdDirection::stress_given)
        continue;
      constexpr double step = 1e-7;
      Mandel up = strain, down = strain;
      up[j] += step;
      down[j] -= step;
      const Mandel above = path.update(up, third), below = path.update(down, third);
      for (unsigned int i = 0; i < 4; ++i)
        BOOST_TEST(std::abs(tangent[4 * i + j] - (above[i] - below[i]) / (2. * step)) < 1e-6 * young);
    }
  }
} // namespace


BOOST_AUTO_TEST_SUITE(two_step_flow)

BOOST_AUTO_TEST_CASE(orders_one_and_two)
{
  const double beyond = radius / (2. * shear); // turns by 50 degrees
  const double first = error("backward Euler", 80, beyond) / error("backward Euler", 160, beyond);
  const double second = error("two steps", 80, beyond) / error("two steps", 160, beyond);
  BOOST_TEST(first == 2., boost::test_tools::tolerance(.05));
  BOOST_TEST(second == 4., boost::test_tools::tolerance(.1));
  BOOST_TEST(20. * error("two steps", 80, beyond) < error("backward Euler", 80, beyond));
}

BOOST_AUTO_TEST_CASE(stable_where_increments_are_many_elastic_strains_long)
{
  // Two increments may not see the turn; afterwards the direction is that of the strain rate.
  BOOST_TEST(error("two steps", 10, 200. * radius / (2. * shear)) < 1e-6);
}

BOOST_AUTO_TEST_CASE(tangent_solid)
{
  check_tangent(ThirdDirection::strain_given);
}

BOOST_AUTO_TEST_CASE(tangent_plane_stress)
{
  check_tangent(ThirdDirection::stress_given);
}

BOOST_AUTO_TEST_CASE(nothing_flows_after_a_reversal)
{
  const auto material = make("two steps");
  Path path(*material);
  path.update(combined(.01, 0.));
  path.commit();
  path.predictor.predict(1.);
  path.update(combined(.0095, 0.));
  for (unsigned int i = 0; i < material->history_size(); ++i)
    BOOST_TEST(path.history.trial(0)[i] == path.history.committed(0)[i]);
}

BOOST_AUTO_TEST_CASE(nothing_is_carried_without_a_last_increment_or_far_beyond_it)
{
  Bdf2Predictor flow(1, 5);
  BOOST_TEST(flow.predict(1.));
  BOOST_TEST(!flow.predict(0.));
  BOOST_TEST(flow.at(0) == nullptr);
  BOOST_TEST(!flow.predict(1.01 * Bdf2Predictor::largest_ratio));
  BOOST_TEST(!Bdf2Predictor().predict(1.));
}

BOOST_AUTO_TEST_CASE(estimated_error_is_half_the_sine_of_the_turn)
{
  const double pressure = 1000.; // has no part in it
  const auto stress = [&](const double psi) {
    Mandel s = combined(std::cos(psi), std::sin(psi));
    for (unsigned int k = 0; k < 3; ++k)
      s[k] += pressure;
    return s;
  };
  BOOST_TEST(flow_error(stress(.3), stress(.5)) == .5 * std::sin(.2), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(flow_error(stress(.3), stress(.3)) < 1e-7);
  BOOST_TEST(flow_error(combined(1., 0.), combined(-2., 0.)) < 1e-7);
  BOOST_TEST(flow_error(Mandel{}, stress(.3)) == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
