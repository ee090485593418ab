// The return map for any yield surface: Mises as in the closed forms, Hill's plane strain and bulge, backstress.
#include "material_cases.h"

#include <limits>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  const Elasticity elastic(69004., .3);

  std::unique_ptr<Hardening> law_of(const std::string &name)
  {
    if (name == "vertical")
      return hardening_of(Ludwik{0., 500., .2});
    return make_hardening(name);
  }

  /// The same random path by the closed form and by the general return map.
  void check_path(const std::string &law, const ThirdDirection third, const double size, const bool two_steps)
  {
    const Elastoplastic closed(elastic, {law_of(law), make_mises()}), general(elastic, {law_of(law), general_mises()});
    MaterialPoint one(closed, two_steps), other(general, two_steps);
    std::mt19937 generator(11);
    const double E = elastic.young;
    for (unsigned int step = 0; step < 20; ++step)
    {
      Mandel e = random_strain(generator, size), e_other = e;
      std::array<double, 16> C{}, C_other{};
      const double third_stress = step % 3 - 1.;
      const Mandel expected = one.update(e, third, third_stress, C.data());
      const Mandel stress = other.update(e_other, third, third_stress, C_other.data());
      BOOST_TEST_REQUIRE(one.status.good());
      BOOST_TEST_REQUIRE(other.status.good());
      require_close(stress, expected, 1e-12 * norm(expected), "the stress");
      require_close(e_other, e, 1e-12 * norm(e), "the strain");
      for (unsigned int i = 0; i < 16; ++i)
        require_close(C_other[i], C[i], 1e-12 * E, "the tangent");
      for (unsigned int i = 0; i < closed.history_size(); ++i)
        require_close(other.trial[i], one.trial[i], 1e-12 * one.equivalent_plastic_strain(), "the history");
      one.commit();
      other.commit();
    }
  }

  /// Stress of a perfectly plastic sheet of flow stress 100 that has been stretched to @p e1, @p e2, by @p surface.
  Mandel stretched(std::unique_ptr<YieldSurface> surface, const double e1, const double e2)
  {
    const Elastoplastic metal(elastic, {hardening_of(PerfectlyPlastic{100.}), std::move(surface)});
    MaterialPoint point(metal);
    Mandel stress;
    for (unsigned int step = 1; step <= 100; ++step)
    {
      Mandel e{{.01 * step * e1, .01 * step * e2, 0., 0.}};
      stress = point.update(e, ThirdDirection::stress_given);
      BOOST_TEST_REQUIRE(point.status.good());
      point.commit();
    }
    return stress;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(general_return)

BOOST_AUTO_TEST_CASE(mises_is_its_closed_form)
{
  for (const std::string law : {"perfectly plastic", "linear", "swift", "ludwik", "voce", "hockett-sherby",
                                "two-branch power", "table", "vertical"})
    for (const auto third : {ThirdDirection::strain_given, ThirdDirection::stress_given})
      for (const double size : {1e-4, 1e-3, 3e-2, .5})
        for (const bool two_steps : {false, true})
          BOOST_TEST_CONTEXT(law << (third == ThirdDirection::strain_given ? ", solid" : ", shell") << ", strain "
                                 << size)
  check_path(law, third, size, two_steps);
}

// Equibiaxial s sqrt((1+r)/2), plane strain s (1+r)/sqrt(1+2r), with planar anisotropy in plane strain along the
// rolling direction s [(G+H) - H^2/(F+H)]^(-1/2).
BOOST_AUTO_TEST_CASE(hill)
{
  for (const double r : {.6, 1., 2.3})
  {
    const double biaxial = 100. * std::sqrt((1. + r) / 2.), plane = 100. * (1. + r) / std::sqrt(1. + 2. * r);
    require_close(stretched(normal_anisotropy(r), .3, .3), {{biaxial, biaxial, 0., 0.}}, 1e-11, "the bulge's stress");
    require_close(stretched(normal_anisotropy(r), 1., 0.), {{plane, plane * r / (1. + r), 0., 0.}}, 1e-9,
                  "plane strain");
  }
  require_close(stretched(std::make_unique<Hill48>(1.79, 1.51, 2.27), 1., 0.)[0], 134.2767, 1e-4, "plane strain");
}

// Legs of plastic strain in shear, where the law is that of a bar: exact values of the bar, and the recursion of
// backward Euler to round-off. P.J. Armstrong, C.O. Frederick, CEGB report RD/B/N 731 (1966).
BOOST_AUTO_TEST_CASE(armstrong_and_frederick)
{
  constexpr double s = 200., C = 20000., gamma = 100., n_steps = 2000;
  const std::array<double, 4> exact = {{326.424112, -355.823300, 351.844553, -352.383018}};
  FlowLaws laws{hardening_of(PerfectlyPlastic{s}),
                make_mises(),
                std::make_unique<Chaboche>(std::vector<Chaboche::Part>{{C, gamma}})};
  const Elastoplastic metal(elastic, std::move(laws), Elastoplastic::Integration::backward_euler);
  for (const auto third : {ThirdDirection::strain_given, ThirdDirection::stress_given})
  {
    MaterialPoint point(metal);
    double alpha = 0., plastic = 0.;
    for (unsigned int leg = 0; leg < 4; ++leg)
    {
      const double x = (leg == 0 ? .01 : .02) / n_steps, sign = leg % 2 == 0 ? 1. : -1.;
      double bar = 0.;
      for (unsigned int step = 0; step < n_steps; ++step)
      {
        alpha = (alpha + sign * C * x) / (1. + gamma * x);
        plastic += sign * x;
        bar = alpha + sign * s;
        const double shear = std::sqrt(2. / 3.) * bar;
        Mandel e{{0., 0., 0., std::sqrt(1.5) * plastic + shear / (2. * elastic.shear)}};
        require_close(point.update(e, third), {{0., 0., 0., shear}}, 1e-9, "the stress");
        point.commit();
      }
      require_close(bar, exact[leg], .1, "the stress of the bar");
    }
  }
}

BOOST_AUTO_TEST_CASE(rate_and_heat_of_a_bar)
{
  // In shear, perfectly plastic, one step: s = 100 (1 + (rate/D)^(1/p)), M12 of mild steel at a rate of 1: 1.47723.
  FlowLaws laws{hardening_of(PerfectlyPlastic{100.}),
                make_mises(),
                nullptr,
                std::make_unique<CowperSymondsWithHeat>(40.4, 5., 0., 0.)};
  const Elastoplastic metal(elastic, std::move(laws));
  MaterialPoint point(metal); // half a unit of time
  const double shear = std::sqrt(2. / 3.) * 147.723;
  const double e = std::sqrt(1.5) * .5 + shear / (2. * elastic.shear);
  require_close(point.solid({{0., 0., 0., e}}), {{0., 0., 0., shear}}, 1e-3, "the stress");
  require_close(point.equivalent_plastic_strain(), .5, 1e-7, "the equivalent plastic strain");
}

BOOST_AUTO_TEST_CASE(what_does_not_go_together)
{
  const auto only_shells = [] { return std::make_unique<PlaneStressOnly>(normal_anisotropy(.6)); };
  const Elastoplastic metal(elastic, {hardening_of(PerfectlyPlastic{100.}), only_shells()});
  BOOST_TEST(!metal.traits().strain_given);
  BOOST_TEST(metal.traits().stress_given);
  MaterialPoint point(metal);
  BOOST_CHECK_THROW(point.solid({}), dealii::ExceptionBase);
  const auto laws = [&] {
    return FlowLaws{hardening_of(PerfectlyPlastic{100.}),
                    only_shells(),
                    std::make_unique<Chaboche>(std::vector<Chaboche::Part>{{1., 1.}})};
  };
  BOOST_CHECK_THROW(Elastoplastic(elastic, laws()), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_layout_is_that_of_all_laws)
{
  const Elastoplastic metal(elastic,
                            {hardening_of(PerfectlyPlastic{100.}),
                             make_mises(),
                             std::make_unique<Chaboche>(std::vector<Chaboche::Part>{{1., 1.}, {2., 0.}}),
                             std::make_unique<CowperSymondsWithHeat>(40.4, 5., 0., 0.)});
  BOOST_TEST(metal.history_layout().to_string() ==
             "plastic_strain:tensor equivalent_plastic_strain:positive backstress_1:tensor backstress_2:tensor "
             "temperature_rise:positive");
  BOOST_TEST(!metal.traits().symmetric_tangent);
  BOOST_TEST(metal.traits().needs_duration);
}

BOOST_AUTO_TEST_SUITE_END()
