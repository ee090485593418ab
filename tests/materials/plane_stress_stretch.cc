// Uniaxial and equibiaxial stretch in plane stress, logarithmic strain to .8: the Kirchhoff stress follows the
// hardening law (reference problem 1). For a stretch without unloading in a fixed direction backward Euler is exact, so
// one step and eighty give the same.
#include "material_point.h"

#include <boost/math/tools/roots.hpp>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// The stress t at which t = flow(e_p), e_p = @p total - t / @p stiffness.
  double stress_on_the_curve(const Hardening &law, const double total, const double stiffness)
  {
    if (law.evaluate(0.).value >= stiffness * total)
      return stiffness * total;
    const auto excess = [&](const double t) { return t - law.evaluate(std::max(0., total - t / stiffness)).value; };
    std::uintmax_t n_iterations = 200;
    const auto bracket = boost::math::tools::toms748_solve(
      excess, 0., stiffness * total, boost::math::tools::eps_tolerance<double>(53), n_iterations);
    return (bracket.first + bracket.second) / 2.;
  }

  enum class Stretch
  {
    uniaxial,
    equibiaxial
  };

  /// Returns the largest relative error of stress and strain.
  double stretch(const Material &material, const Hardening &law, const Stretch kind, const unsigned int n_steps)
  {
    const double E = material.young_modulus(), nu = material.poisson_ratio();
    MaterialPoint point(material);
    double worst = 0.;
    for (unsigned int step = 1; step <= n_steps; ++step)
    {
      const double e1 = .8 * step / n_steps;
      double t = 0., plastic = 0., thickness_strain = 0.;
      Mandel strain{}, expected{};
      if (kind == Stretch::uniaxial)
      {
        t = stress_on_the_curve(law, e1, E);
        plastic = e1 - t / E;
        thickness_strain = -nu * t / E - plastic / 2.;
        strain = {{e1, thickness_strain, 0., 0.}};
        expected = {{t, 0., 0., 0.}};
      }
      else
      {
        // plastic strain p in both directions, -2 p in the third: equivalent 2 p
        t = stress_on_the_curve(law, 2. * e1, E / (2. * (1. - nu)));
        plastic = 2. * (e1 - (1. - nu) * t / E);
        thickness_strain = -2. * nu * t / E - plastic;
        strain = {{e1, e1, 0., 0.}};
        expected = {{t, t, 0., 0.}};
      }
      const Mandel stress = point.update(strain, ThirdDirection::stress_given);
      BOOST_TEST(point.status.good());
      worst = std::max({worst, norm(difference(stress, expected)) / t, std::abs(strain[2] - thickness_strain) / e1});
      BOOST_TEST(norm(difference(stress, expected)) <= 1e-10 * t);
      BOOST_TEST(std::abs(strain[2] - thickness_strain) <= 1e-10 * e1);
      BOOST_TEST(std::abs(point.equivalent_plastic_strain() - plastic) <= 1e-10 * e1);
      if (plastic > 0.) // the statement of the problem itself, without the solution above
        BOOST_TEST(std::abs(stress[0] - law.evaluate(point.equivalent_plastic_strain()).value) <= 1e-10 * t);
      point.commit();
    }
    return worst;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(plane_stress_stretch)

BOOST_AUTO_TEST_CASE(every_material_with_every_hardening_law)
{
  double worst = 0.;
  for (const auto &name : laws_of_strain())
    for (const double young : {2e3, 69004., 1e7})
      BOOST_TEST_CONTEXT(name << ", E = " << young)
      {
        const auto law = make_hardening(name);
        const auto material = make_material(
          "elastoplastic", name, {"Material/Young's modulus=" + std::to_string(young), "Material/Poisson's ratio=.3"});
        for (const auto kind : {Stretch::uniaxial, Stretch::equibiaxial})
          for (const unsigned int n_steps : {1, 80})
            worst = std::max(worst, stretch(*material, *law, kind, n_steps));
      }
  BOOST_TEST_MESSAGE("largest relative error of stress and thickness strain: " << worst);
}

BOOST_AUTO_TEST_CASE(as_printed_on_either_side_of_its_jump)
{
  const std::vector<std::string> entries = {"Initial flow stress=5.4",
                                            "First coefficient=27.8",
                                            "First exponent=.504",
                                            "Second coefficient=24.4",
                                            "As printed=true"};
  std::vector<std::string> overrides = {"Material/Young's modulus=13393", "Material/Hardening/As printed=true"};
  const auto material = make_material("elastoplastic", "two-branch power", overrides);
  for (const double e : {.2, .35, .37, .8})
  {
    MaterialPoint point(*material);
    Mandel strain{{e, -e / 2., 0., 0.}};
    const Mandel stress = point.update(strain, ThirdDirection::stress_given);
    BOOST_TEST(point.status.good());
    const double plastic = point.equivalent_plastic_strain();
    const double expected = 5.4 + (e < .36 ? 27.8 : 24.4) * std::pow(plastic, .504);
    BOOST_TEST(std::abs(mises(stress) - expected) <= 1e-12 * expected);
  }
}

BOOST_AUTO_TEST_SUITE_END()
