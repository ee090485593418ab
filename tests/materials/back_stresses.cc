// Registered backstresses against exact and independent values of a bar and of a sheet.
#include "material_cases.h"

#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>

#include <Eigen/Dense>

#include <boost/math/tools/roots.hpp>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  std::unique_ptr<BackStress> back_stress(const std::string &law, const std::vector<std::string> &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    auto result = Registry<BackStress>::make(law, section);
    tree.check_unused();
    return result;
  }

  std::unique_ptr<Elastoplastic> metal(const Elasticity &elastic, const double s, std::unique_ptr<BackStress> back)
  {
    FlowLaws laws{hardening_of(PerfectlyPlastic{s}), make_mises(), std::move(back)};
    return std::make_unique<Elastoplastic>(elastic, std::move(laws), Elastoplastic::Integration::two_steps);
  }

  /// A bar under tension: a sheet of which the edges are free.
  struct Bar
  {
    explicit Bar(const Material &material, const bool two_steps = true)
      : point(material, two_steps), poisson(material.poisson_ratio())
    {
    }

    /// Stress at a strain along the bar.
    double stress(const double strain)
    {
      Mandel t{};
      e[1] += -.5 * (strain - e[0]);
      e[0] = strain;
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
      {
        std::array<double, 16> C{};
        t = point.update(e, ThirdDirection::stress_given, 0., C.data());
        BOOST_TEST_REQUIRE(point.status.good());
        if (std::abs(t[1]) < 1e-9)
          break;
        e[1] -= t[1] / C[5];
      }
      BOOST_TEST_REQUIRE(std::abs(t[1]) < 1e-9);
      return t[0];
    }

    double go(const double strain, const double step)
    {
      const double from = e[0];
      const auto n = static_cast<unsigned int>(std::ceil(std::abs(strain - from) / step - 1e-9));
      double t = 0.;
      std::fill(point.predictor.begin(), point.predictor.end(), 0.); // the steps have another length
      for (unsigned int i = 1; i <= n; ++i)
      {
        t = stress(from + (strain - from) * i / n);
        point.commit();
      }
      return t;
    }

    MaterialPoint point;
    double poisson;
    Mandel e{};
  };

  const std::vector<std::string> dp780 = {"Yield stress=337",
                                          "Bounding stress=620",
                                          "Yield surface rate=500",
                                          "Bounding surface rate=34",
                                          "Bounding backstress=202",
                                          "Stagnation=.772",
                                          "Saturation stress=190"};

  void check_refused(const std::string &law, const std::vector<std::string> &entries, const std::string &entry)
  {
    BOOST_CHECK_EXCEPTION(back_stress(law, entries), SceneError, [&](const SceneError &error) {
      return std::string(error.what()).find(entry) != std::string::npos;
    });
  }
} // namespace

BOOST_AUTO_TEST_SUITE(back_stresses)

// Legs of plastic strain +.01 -.02 +.02 -.02 of a bar: exact. P.J. Armstrong, C.O. Frederick (1966). The strain of a
// leg's end is its plastic one and the elastic one of the exact stress.
BOOST_AUTO_TEST_CASE(armstrong_and_frederick)
{
  const std::array<double, 4> exact = {{326.424112, -355.823300, 351.844553, -352.383018}};
  const Elasticity elastic(200e3, .3);
  const auto law = metal(elastic, 200., back_stress("chaboche", {"Terms=20000 100"}));
  Bar bar(*law);
  double plastic = 0.;
  for (unsigned int leg = 0; leg < 4; ++leg)
  {
    plastic += leg == 0 ? .01 : (leg % 2 == 1 ? -.02 : .02);
    const double t = bar.go(plastic + exact[leg] / elastic.young, 5e-6);
    BOOST_TEST_MESSAGE("leg " << leg << ": " << t << ", exact " << exact[leg]);
    require_close(t, exact[leg], 2e-3, "the stress of the bar");
  }
}

// Two terms, one of them linear, are the sum of both.
BOOST_AUTO_TEST_CASE(saturation)
{
  const auto law =
    metal(Elasticity(200e3, .3), 200., back_stress("chaboche", {"Terms=20000 100; 6000 200; 500 0"}));
  Bar bar(*law);
  const double t = bar.go(.2, 1e-4), plastic = .2 - t / 200e3;
  require_close(t, 200. + 20000. / 100. + 6000. / 200. + 500. * plastic, 1e-5, "the stress of the bar");
}

// Linear kinematic hardening, not proportional: test SSNP14 of the Code_Aster manual. Stress is given; converged own
// values.
BOOST_AUTO_TEST_CASE(tension_and_shear_that_turn)
{
  constexpr double E = 195000., ET = 1930.;
  const Elasticity elastic(E, .3);
  std::ostringstream H;
  H << std::setprecision(17) << "Hardening modulus=" << E * ET / (E - ET);
  const auto law = metal(elastic, 181., back_stress("linear", {H.str()}));
  const double paths[4][4] = {{151.2, 93.1, .01482971, .01360140},
                              {257.2, 33.1, .0406419, .0200126},
                              {259.3, 0., .0442172, .0193175},
                              {0., 0., .0428875, .0193175}};
  const double root_2 = std::sqrt(2.);
  MaterialPoint point(*law, true);
  Mandel e{};
  double from_direct = 0., from_shear = 0.;
  for (const auto &[direct, shear, e_direct, e_shear] : paths)
  {
    constexpr unsigned int n = 4000;
    std::fill(point.predictor.begin(), point.predictor.end(), 0.);
    for (unsigned int step = 1; step <= n; ++step)
    {
      const double part = double(step) / n;
      const Eigen::Vector3d wanted(
        from_direct + part * (direct - from_direct), 0., root_2 * (from_shear + part * (shear - from_shear)));
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
      {
        std::array<double, 16> C{};
        const Mandel t = point.update(e, ThirdDirection::stress_given, 0., C.data());
        BOOST_TEST_REQUIRE(point.status.good());
        const Eigen::Vector3d residual = Eigen::Vector3d(t[0], t[1], t[3]) - wanted;
        if (residual.norm() < 1e-8)
          break;
        BOOST_TEST_REQUIRE(iteration < 25u);
        Eigen::Matrix3d tangent;
        tangent << C[0], C[1], C[3], C[4], C[5], C[7], C[12], C[13], C[15];
        const Eigen::Vector3d change = tangent.partialPivLu().solve(residual);
        e[0] -= change[0];
        e[1] -= change[1];
        e[3] -= change[2];
      }
      point.commit();
    }
    BOOST_TEST_MESSAGE("eps_xx " << e[0] << ", eps_xy " << e[3] / root_2);
    require_close(e[0], e_direct, 1e-4 * e_direct, "eps_xx");
    require_close(e[3] / root_2, e_shear, 1e-4 * e_shear, "eps_xy");
    from_direct = direct;
    from_shear = shear;
  }
}

// DP780, strain of a bar to and fro: an own program, to .01. F. Yoshida, T. Uemori (2002).
BOOST_AUTO_TEST_CASE(yoshida_and_uemori)
{
  const auto law = metal(Elasticity(200e3, .33), 337., back_stress("yoshida-uemori", dp780));
  Bar bar(*law);
  const double path[9][2] = {{.01, 644.22},
                             {.02, 765.93},
                             {.05, 921.88},
                             {.08, 979.18},
                             {.05, -805.23},
                             {0., -970.32},
                             {-.05, -1004.34},
                             {0., 910.48},
                             {.05, 992.41}};
  for (const auto &[strain, stress] : path)
  {
    const double t = bar.go(strain, 1e-5);
    BOOST_TEST_MESSAGE("strain " << strain << ": " << t << ", reference " << stress);
    require_close(t, stress, .03, "the stress of the bar");
  }
}

BOOST_AUTO_TEST_CASE(what_is_refused)
{
  check_refused("linear", {}, "Hardening modulus");
  check_refused("linear", {"Hardening modulus=-1"}, "Hardening modulus");
  check_refused("chaboche", {"Terms=100 -1"}, "Terms");
  check_refused("chaboche", {"Terms=-100 1"}, "Terms");
  check_refused("chaboche", {"Terms="}, "Terms");
  for (const std::string bad : {"Bounding stress=300", "Stagnation=1.1", "Saturation stress=-1"})
  {
    auto entries = dp780;
    for (auto &entry : entries)
      if (entry.substr(0, entry.find('=')) == bad.substr(0, bad.find('=')))
        entry = bad;
    check_refused("yoshida-uemori", entries, bad.substr(0, bad.find('=')));
  }
  const auto hardened_twice = [] {
    return FlowLaws{hardening_of(Swift{589., 1e-4, .216}), make_mises(), back_stress("yoshida-uemori", dp780)};
  };
  BOOST_CHECK_THROW(Elastoplastic(Elasticity(200e3, .3), hardened_twice()), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
