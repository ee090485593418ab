// Registered yield surfaces against closed forms of sheet metal: ratios of stress, what is refused, and what they cost.
#include "material_cases.h"

#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

#include <boost/math/tools/roots.hpp>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double s = 100.; // flow stress

  std::unique_ptr<YieldSurface> surface(const std::string &law, const std::vector<std::string> &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    auto result = Registry<YieldSurface>::make(law, section);
    tree.check_unused();
    return result;
  }

  std::unique_ptr<Elastoplastic> metal(std::unique_ptr<YieldSurface> yield)
  {
    return std::make_unique<Elastoplastic>(
      Elasticity(69004., .3), FlowLaws{hardening_of(PerfectlyPlastic{s}), std::move(yield)});
  }

  /// Stress of a perfectly plastic sheet that has been stretched by @p e1, @p e2 in @p n steps.
  Mandel stretched(const Material &material, const double e1, const double e2, const unsigned int n)
  {
    MaterialPoint point(material);
    Mandel stress{};
    for (unsigned int step = 1; step <= n; ++step)
    {
      Mandel e{{e1 * step / n, e2 * step / n, 0., 0.}};
      stress = point.update(e, ThirdDirection::stress_given);
      BOOST_TEST_REQUIRE(point.status.good());
      point.commit();
    }
    return stress;
  }

  /// Strains across and through the sheet of a bar that is stretched along direction 1, increment by increment.
  double measured_r(const Material &material)
  {
    MaterialPoint point(material);
    const double E = material.young_modulus(), nu = material.poisson_ratio();
    Mandel e{{.01, 0., 0., 0.}};
    const auto across = [&](const double e2) {
      e[1] = e2;
      return point.update(e, ThirdDirection::stress_given)[1];
    };
    std::uintmax_t n = 200;
    const auto bracket = boost::math::tools::toms748_solve(
      across, -.012, .006, boost::math::tools::eps_tolerance<double>(53), n);
    const Mandel t = point.update(e = {{.01, bracket.first, 0., 0.}}, ThirdDirection::stress_given);
    return (e[1] + nu * t[0] / E) / (e[2] + nu * t[0] / E);
  }

  void check_refused(const std::string &law, const std::vector<std::string> &entries, const std::string &entry)
  {
    BOOST_CHECK_EXCEPTION(surface(law, entries), SceneError, [&](const SceneError &error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).find(entry) != std::string::npos;
    });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(yield_surfaces)

// Equibiaxial s sqrt((1+r)/2); plane strain s (1+r)/sqrt(1+2r), s2/s1 = r/(1+r); r of a bar. R. Hill (1948).
BOOST_AUTO_TEST_CASE(hill_with_normal_anisotropy)
{
  for (const double r : {-.3, 0., .6, 1., 1.8, 4.})
  {
    const auto law = metal(surface("hill", {"r-bar=" + text::format(r)}));
    const double biaxial = s * std::sqrt((1. + r) / 2.), plane = s * (1. + r) / std::sqrt(1. + 2. * r);
    require_close(stretched(*law, .3, .3, 20), {{biaxial, biaxial, 0., 0.}}, 1e-11, "the bulge's stress");
    require_close(stretched(*law, 1., 0., 20), {{plane, plane * r / (1. + r), 0., 0.}}, 1e-9, "plane strain");
    require_close(measured_r(*law), r, 1e-9, "r of a bar");
  }
}

// What is solved in the plane of a shell is the solution of the general return map.
void
check_closed_form(const std::string &law, const std::vector<std::string> &entries)
{
  const Elasticity elastic(69004., .3);
  const Swift swift = Swift::parameters().example();
  for (const double size : {1e-3, 3e-2, .5})
  {
    const Elastoplastic closed(elastic, {hardening_of(swift), surface(law, entries)}),
      general(elastic, {hardening_of(swift), std::make_unique<WithoutClosedForm>(surface(law, entries))});
    MaterialPoint one(closed, true), other(general, true);
    std::mt19937 generator(12);
    for (unsigned int step = 0; step < 20; ++step)
    {
      Mandel e = random_strain(generator, size);
      if (step % 5 == 4) // equal principal strains, and nearly so
      {
        e[1] = e[0] + (step % 2 == 0 ? 0. : 1e-9);
        e[3] = 0.;
      }
      Mandel e_other = e;
      std::array<double, 16> C{}, C_other{};
      const Mandel expected = other.update(e_other, ThirdDirection::stress_given, step % 3 - 1., C_other.data());
      const Mandel stress = one.update(e, ThirdDirection::stress_given, step % 3 - 1., C.data());
      require_close(stress, expected, 1e-11 * norm(expected), "the stress");
      require_close(e, e_other, 1e-11 * norm(e), "the strain");
      const double tolerance = law == "hill" ? 1e-11 : 1e-8; // of the last but one step of Newton's method
      for (unsigned int i = 0; i < 16; ++i)
        require_close(C[i], C_other[i], tolerance * elastic.young, "the tangent");
      one.commit();
      other.commit();
    }
  }
}

BOOST_AUTO_TEST_CASE(hill_is_its_closed_form)
{
  for (const double r : {-.3, .6, 1., 2.3})
    check_closed_form("hill", {"r-bar=" + text::format(r)});
}

BOOST_AUTO_TEST_CASE(hosford_in_principal_axes_is_the_general_one)
{
  for (const std::string a : {"2", "2.5", "6", "8", "20", "50"})
    for (const std::string r : {"0", ".6", "1", "1.8"})
      BOOST_TEST_CONTEXT("a = " << a << ", r = " << r)
  check_closed_form("hosford", {"Exponent=" + a, "r-bar=" + r});
}

// r0, r90: along the rolling direction s1/s = [(G+H) - H^2/(F+H)]^(-1/2), across [(F+H) - H^2/(G+H)]^(-1/2); mild steel
// 1.79, 2.27: 1.342767.
BOOST_AUTO_TEST_CASE(hill_with_a_rolling_direction)
{
  for (const auto &[r0, r90] : {std::pair(1.79, 2.27), std::pair(.8, .54), std::pair(.3, 3.)})
  {
    const double G = 1. / (1. + r0), H = r0 / (1. + r0), F = r0 / (r90 * (1. + r0));
    const std::vector<std::string> both = {"r0=" + text::format(r0), "r90=" + text::format(r90)};
    auto across = both;
    across.emplace_back("Rolling direction=across");
    const auto law = metal(surface("hill", both)), turned = metal(surface("hill", across));
    require_close(
      stretched(*law, 1., 0., 20)[0], s / std::sqrt(G + H - H * H / (F + H)), 1e-8, "plane strain along");
    require_close(
      stretched(*turned, 1., 0., 20)[0], s / std::sqrt(F + H - H * H / (G + H)), 1e-8, "plane strain across");
    require_close(measured_r(*law), r0, 1e-9, "r0");
    require_close(measured_r(*turned), r90, 1e-9, "r90");
    BOOST_TEST((law->traits().symmetry == Symmetry::orthotropic));
  }
  const auto steel = metal(surface("hill", {"r0=1.79", "r90=2.27"}));
  require_close(stretched(*steel, 1., 0., 20)[0], 134.2767, 5e-5, "plane strain of mild steel");
}

BOOST_AUTO_TEST_CASE(what_hill_refuses)
{
  check_refused("hill", {"r-bar=-.5"}, "r-bar");
  check_refused("hill", {"r-bar=-.6"}, "r-bar");
  check_refused("hill", {"r-bar=nan"}, "r-bar");
  check_refused("hill", {}, "r-bar");
  check_refused("hill", {"r0=1.79"}, "r90");
  check_refused("hill", {"r90=1.79"}, "r0");
  check_refused("hill", {"r0=-.1", "r90=1"}, "r0");
  check_refused("hill", {"r0=1", "r90=0"}, "r90");
  check_refused("hill", {"r0=1", "r90=2", "r-bar=1"}, "r-bar");
  check_refused("hill", {"r0=1", "r90=2", "Rolling direction=up"}, "Rolling direction");
}

// Plane strain s2/s1 = c/(1+c), c = r^(1/(a-1)), s1/s = [(1+r)/(1 + alpha^a + r (1-alpha)^a)]^(1/a); equibiaxial and
// compression along the normal ((1+r)/2)^(1/a); shear s1 - s2 = 2 [(1+r)/(2 + r 2^a)]^(1/a) s. Steps of 1 and of 10 %.
BOOST_AUTO_TEST_CASE(hosford)
{
  for (const double a : {2., 6., 8., 20., 50.})
    for (const double r : {.3, 1., 1.8})
      for (const unsigned int n : {10u, 100u})
      {
        const auto law = metal(surface("hosford", {"Exponent=" + text::format(a), "r-bar=" + text::format(r)}));
        const double c = std::pow(r, 1. / (a - 1.)), alpha = c / (1. + c);
        const double plane = s * std::pow((1. + r) / (1. + std::pow(alpha, a) + r * std::pow(1. - alpha, a)), 1. / a);
        const double biaxial = s * std::pow((1. + r) / 2., 1. / a);
        const double shear = s * std::pow((1. + r) / (2. + r * std::pow(2., a)), 1. / a);
        BOOST_TEST_CONTEXT("a = " << a << ", r = " << r << ", " << n << " steps")
        {
          require_close(stretched(*law, .5, .5, n), {{biaxial, biaxial, 0., 0.}}, 1e-10, "the bulge's stress");
          const YieldPoint at = surface("hosford", {"Exponent=" + text::format(a), "r-bar=" + text::format(r)})
                                  ->evaluate({{plane, plane * alpha, 0., 0.}});
          require_close(at.value, s, 1e-11, "q of plane strain");
          require_close(at.gradient[1], 0., 1e-12, "flow across in plane strain");
          if (a <= 8.) // beyond, the surface is so flat there that elastic strains take their time
            require_close(stretched(*law, 1., 0., n), {{plane, plane * alpha, 0., 0.}}, 1e-7, "plane strain");
          require_close(stretched(*law, .5, -.5, n), {{shear, -shear, 0., 0.}}, 1e-10, "shear");
          require_close(measured_r(*law), r, 1e-7, "r of a bar");
        }
      }
}

BOOST_AUTO_TEST_CASE(hosford_of_exponent_2_is_hill)
{
  const auto law = surface("hosford", {"Exponent=2", "r-bar=.6"}), hill = surface("hill", {"r-bar=.6"});
  std::mt19937 generator(13);
  for (unsigned int k = 0; k < 50; ++k)
  {
    const Mandel t = random_strain(generator, 100.);
    const YieldPoint one = law->evaluate(t), other = hill->evaluate(t);
    require_close(one.value, other.value, 1e-12 * s, "q");
    require_close(one.gradient, other.gradient, 1e-12, "the gradient");
    for (unsigned int i = 0; i < 16; ++i)
      require_close(one.hessian[i], other.hessian[i], 1e-12, "the curvature");
  }
}

// Gradient and curvature against differences, also where two principal stresses are nearly equal.
BOOST_AUTO_TEST_CASE(derivatives)
{
  std::mt19937 generator(14);
  for (const std::string a : {"2", "2.5", "6", "20"})
    for (const double shear : {1., 1e-3, 1e-8, 0.})
      for (unsigned int k = 0; k < 20; ++k)
      {
        const auto law = surface("hosford", {"Exponent=" + a, "r-bar=1.7"});
        Mandel t = random_strain(generator, 1.);
        if (shear < 1.)
        {
          t[1] = t[0] + shear;
          t[3] *= shear;
        }
        const YieldPoint at = law->evaluate(t);
        for (unsigned int j = 0; j < 4; ++j)
        {
          const double h = 1e-5 * at.value;
          Mandel plus = t, minus = t;
          plus[j] += h;
          minus[j] -= h;
          const YieldPoint above = law->evaluate(plus), below = law->evaluate(minus);
          require_close(at.gradient[j], (above.value - below.value) / (2. * h), 1e-6, "the gradient");
          for (unsigned int i = 0; i < 4; ++i)
            require_close(at.hessian[4 * i + j],
                          (above.gradient[i] - below.gradient[i]) / (2. * h),
                          (a == "2.5" ? 5e-2 : 1e-5) / at.value,
                          "the curvature");
        }
      }
}

// Random paths with steps of several per cent, quadratic at the end: a sheet that changes its mind all the time.
BOOST_AUTO_TEST_CASE(hosford_is_robust)
{
  std::mt19937 generator(15);
  for (const std::string a : {"6", "20", "50"})
    for (const std::string r : {"0", ".4", "1", "3"})
      for (const double size : {1e-3, 1e-2, .1, 1.})
        for (const auto third : {ThirdDirection::strain_given, ThirdDirection::stress_given})
        {
          const auto law = metal(surface("hosford", {"Exponent=" + a, "r-bar=" + r}));
          MaterialPoint point(*law);
          for (unsigned int step = 0; step < 50; ++step)
          {
            Mandel e = random_strain(generator, size);
            if (step % 2 == 0)
              e[3] = 0.;
            const Mandel t = point.update(e, third, 0.);
            BOOST_TEST_REQUIRE(point.status.good());
            BOOST_TEST_REQUIRE(std::isfinite(norm(t)));
            point.commit();
          }
        }
}

BOOST_AUTO_TEST_CASE(what_hosford_refuses)
{
  check_refused("hosford", {"Exponent=.9"}, "Exponent");
  check_refused("hosford", {"Exponent=1.9"}, "Exponent");
  check_refused("hosford", {"r-bar=1"}, "Exponent");
  check_refused("hosford", {"Exponent=8", "r-bar=-.1"}, "r-bar");
}

// AA6022 with a = 8: yield stresses, r values and plane strain of the same alpha, published.
BOOST_AUTO_TEST_CASE(yld2000)
{
  const std::vector<std::string> aluminium = {"Exponent=8",
                                              "Alpha=1.0035 .9636 .8832 1.0481 1.0125 .9947 .9215 1.1918"};
  const auto law = surface("yld2000-2d", aluminium);
  const auto bar = [&](const double degrees) { // stress of a bar at an angle to the rolling direction, r
    const double angle = degrees * std::acos(-1.) / 180., c = std::cos(angle), d = std::sin(angle);
    const YieldPoint at = law->evaluate({{c * c, d * d, 0., std::sqrt(2.) * c * d}});
    const double shear = std::sqrt(2.) * at.gradient[3] * c * d;
    const double across = d * d * at.gradient[0] + c * c * at.gradient[1] - shear;
    return std::array<double, 2>{{1. / at.value, across / at.gradient[2]}};
  };
  const double expected[3][3] = {{0., .9950, .800}, {45., .9678, .370}, {90., .9497, .540}};
  for (const auto &[angle, stress, r] : expected)
  {
    require_close(bar(angle)[0], stress, 1e-4, "the yield stress of a bar");
    require_close(bar(angle)[1], r, 1e-3, "r of a bar");
  }
  require_close(law->equivalent_stress({{1., 1., 0., 0.}}), 1., 1e-4, "equibiaxial q");
  auto across = aluminium;
  across.emplace_back("Rolling direction=across");
  require_close(stretched(*metal(surface("yld2000-2d", aluminium)), 1., 0., 50)[0], 107.72, 6e-3, "along");
  require_close(stretched(*metal(surface("yld2000-2d", across)), 1., 0., 50)[0], 105.75, 6e-3, "across");
}

// Planar isotropy is Logan and Hosford: alpha 1, 2, 7 = (2r/(1+r))^(1/a), the others (2/(1+r))^(1/a).
BOOST_AUTO_TEST_CASE(yld2000_with_planar_isotropy)
{
  constexpr double r = .6;
  std::ostringstream alpha;
  alpha << std::setprecision(17) << "Alpha=";
  for (const unsigned int i : {1, 2, 3, 4, 5, 6, 7, 8})
    alpha << std::pow((i == 1 || i == 2 || i == 7 ? 2. * r : 2.) / (1. + r), 1. / 6.) << " ";
  const auto law = surface("yld2000-2d", {"Exponent=6", alpha.str()});
  const auto hosford = surface("hosford", {"Exponent=6", "r-bar=.6"});
  std::mt19937 generator(16);
  for (unsigned int k = 0; k < 50; ++k)
  {
    const Mandel t = random_strain(generator, 100.);
    const YieldPoint one = law->evaluate(t), other = hosford->evaluate(t);
    require_close(one.value, other.value, 1e-12 * s, "q");
    require_close(one.gradient, other.gradient, 1e-11, "the gradient");
    for (unsigned int i = 0; i < 16; ++i)
      require_close(one.hessian[i], other.hessian[i], 1e-10, "the curvature");
  }
}

BOOST_AUTO_TEST_CASE(what_yld2000_refuses)
{
  check_refused("yld2000-2d", {"Exponent=8"}, "Alpha");
  check_refused("yld2000-2d", {"Exponent=8", "Alpha=1 1 1"}, "Alpha");
  check_refused("yld2000-2d", {"Exponent=8", "Alpha=1 1 1 1 1 1 1 -1"}, "Alpha");
  check_refused("yld2000-2d", {"Exponent=8", "Alpha=1 1 1 1 1 1 1 1; 1 1 1 1 1 1 1 1"}, "Alpha");
}

BOOST_AUTO_TEST_SUITE_END()
