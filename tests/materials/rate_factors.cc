// Registered rate factors: values, and a bar that relaxes.
#include "material_cases.h"

#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  std::unique_ptr<RateFactor> rate_factor(const std::string &law, const std::vector<std::string> &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "test", entries);
    Section section = tree.root();
    auto result = Registry<RateFactor>::make(law, section);
    tree.check_unused();
    return result;
  }

  double factor(const RateFactor &law, const double rate)
  {
    return law.evaluate({100., 0.}, {.01, .01, rate, 1.}, nullptr, nullptr).value / 100.;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(rate_factors)

// Factors of mild steel, D = 40.4 1/s, p = 5; of OFHC copper, C = .025.
BOOST_AUTO_TEST_CASE(values)
{
  const auto steel = rate_factor("cowper-symonds", {"Reference rate=40.4", "Rate exponent=5"});
  require_close(factor(*steel, .01), 1.18999, 5e-6, "Cowper and Symonds at .01");
  require_close(factor(*steel, 1.), 1.47723, 5e-6, "Cowper and Symonds at 1");
  require_close(factor(*steel, 100.), 2.19874, 5e-6, "Cowper and Symonds at 100");
  const auto copper = rate_factor("johnson-cook", {"Rate coefficient=.025", "Reference rate=1"});
  require_close(factor(*copper, std::exp(4.)), 1.1, 1e-12, "Johnson and Cook at e^4");
  require_close(factor(*copper, .5), 1., 1e-15, "Johnson and Cook under the reference rate");
  const auto power = rate_factor("power", {"Overstress=50", "Rate exponent=2"});
  require_close(factor(*power, 4.), 2., 1e-12, "power law at 4");
}

BOOST_AUTO_TEST_CASE(slopes)
{
  for (const auto &name : Registry<RateFactor>::names())
  {
    ParameterTree tree = ParameterTree::documentation();
    Section section = tree.root();
    const auto law = Registry<RateFactor>::make(name, section);
    const HistoryLayout layout = law->history_layout();
    const std::vector<double> start(layout.size() + 1, 0.);
    std::vector<double> end(start);
    const auto at = [&](const double x) {
      return law->evaluate({100. + 300. * x, 300.}, {x, x, x / .01, 1. / .01}, start.data(), end.data());
    };
    for (const double x : {1e-6, 1e-3, .004, .1})
    {
      const double h = 1e-3 * x, numerical = (at(x + h).value - at(x - h).value) / (2. * h);
      BOOST_TEST_CONTEXT(name << " at " << x)
      require_close(at(x).slope, numerical, 1e-6 * std::abs(numerical), "the slope");
    }
  }
}

// A bar held at its strain, no yield stress, rate = (t/100)^5 from 100: t^-4 = 100^-4 + 4 E time/100^5.
BOOST_AUTO_TEST_CASE(relaxation)
{
  const Elasticity elastic(200e3, .3);
  const Elastoplastic metal(elastic,
                            {hardening_of(Ludwik{0., 0., 1.}),
                             make_mises(),
                             nullptr,
                             rate_factor("power", {"Overstress=100", "Rate exponent=5"})});
  MaterialPoint point(metal, true);
  Mandel e{{100. / elastic.young, -.3 * 100. / elastic.young, 0., 0.}};
  const auto stress = [&]() {
    Mandel t{};
    for (unsigned int iteration = 0; iteration < 30; ++iteration)
    {
      std::array<double, 16> C{};
      t = point.update(e, ThirdDirection::stress_given, 0., C.data());
      BOOST_TEST_REQUIRE(point.status.good());
      if (std::abs(t[1]) < 1e-10)
        break;
      e[1] -= t[1] / C[5];
    }
    return t[0];
  };
  point.duration = 1e-13;
  require_close(stress(), 100., 1e-6, "the stress at the start");
  point.commit();
  std::fill(point.predictor.begin(), point.predictor.end(), 0.);
  point.duration = 2e-6;
  const double expected[4][2] = {{1e-4, 86.33400}, {1e-3, 57.73503}, {1e-2, 33.33333}, {.1, 18.79714}};
  unsigned int step = 0;
  for (const auto &[time, t] : expected)
  {
    double now = 0.;
    for (; (step + .5) * point.duration < time; ++step)
    {
      now = stress();
      point.commit();
    }
    BOOST_TEST_MESSAGE("time " << time << ": " << now << ", exact " << t);
    require_close(now, t, 1e-4 * t, "the stress that is left");
  }
}

// Adiabatic copper, Johnson and Cook, sheared slowly: rise of the temperature (K) and flow stress. m = 1 is a closed
// form.
BOOST_AUTO_TEST_CASE(copper_that_heats_itself)
{
  const double expected[2][3][3] = {
    {{.1, 5.21066, 231.86781}, {.5, 34.79431, 314.83342}, {1., 78.96025, 353.49072}},
    {{.1, 5.216, 232.303}, {.5, 34.966, 317.624}, {1., 79.693, 359.201}}};
  for (const unsigned int row : {0u, 1u})
  {
    const Elasticity elastic(124e3, .34);
    std::vector<std::string> entries = {"Material/Young's modulus=124e3", "Material/Poisson's ratio=.34",
                                        "Material/Hardening/Initial flow stress=90",
                                        "Material/Hardening/Strength coefficient=292",
                                        "Material/Hardening/Hardening exponent=.31",
                                        "Material/Rate factor/Law=johnson-cook",
                                        "Material/Rate factor/Rate coefficient=.025",
                                        "Material/Rate factor/Reference rate=1e9",
                                        "Material/Heat/Adiabatic=true",
                                        "Material/Heat/Heat capacity=3.43168",
                                        "Material/Heat/Heated share=.9",
                                        "Material/Heat/Softening=johnson-cook",
                                        "Material/Heat/Melting temperature=1356",
                                        "Material/Heat/Initial temperature=298"};
    entries.emplace_back(row == 0 ? "Material/Heat/Softening exponent=1" : "Material/Heat/Softening exponent=1.09");
    const auto metal = make_material("elastoplastic", "ludwik", entries);
    BOOST_TEST(metal->history_layout().to_string() ==
               "plastic_strain:tensor equivalent_plastic_strain:positive temperature_rise:positive");
    MaterialPoint point(*metal, true);
    double last = 0.;
    Mandel t{};
    for (const auto &[plastic, rise, stress] : expected[row])
    {
      // In shear; the end of every part is where the plastic strain has its value, by the stress that is expected
      // there.
      const double end = std::sqrt(1.5) * (plastic + stress / (3. * elastic.shear));
      constexpr unsigned int n = 4000;
      std::fill(point.predictor.begin(), point.predictor.end(), 0.);
      for (unsigned int i = 1; i <= n; ++i)
      {
        t = point.solid({{0., 0., 0., last + (end - last) * i / n}});
        BOOST_TEST_REQUIRE(point.status.good());
        point.commit();
      }
      last = end;
      const double digits = row == 0 ? 2e-5 : 1e-3;
      BOOST_TEST_MESSAGE("rise " << point.committed[5] << ", stress " << mises(t));
      require_close(mises(t), stress, digits * stress, "the flow stress");
      require_close(point.committed[5], rise, row == 0 ? 1e-4 * rise : 1e-3, "the rise of the temperature");
    }
  }
}

// Tangents by differences where heat takes much of the flow stress: in the increment in which flow begins, at the last
// stress known, in one that goes on and in one that turns.
BOOST_AUTO_TEST_CASE(tangents_of_metal_that_heats_itself)
{
  const Mandel path[4] = {
    {{.0005, -.0002, -.0001, .0002}}, {{.03, -.01, -.015, .01}}, {{.06, -.02, -.03, .02}}, {{.05, -.05, .002, -.02}}};
  const auto check = [&](const Material &metal, const bool two_steps) {
    MaterialPoint point(metal, two_steps);
    point.duration = 1e-3;
    for (const Mandel &e : path)
    {
      std::array<double, 16> C{};
      point.solid(e, C.data());
      BOOST_TEST_REQUIRE(point.status.good());
      // The predictor is an output: what has fallen back once stays so.
      for (unsigned int j = 0; j < 4; ++j)
      {
        const auto difference = [&](const double h) {
          Mandel plus = e, minus = e;
          plus[j] += h;
          minus[j] -= h;
          Mandel d = testing::difference(point.solid(plus), point.solid(minus));
          for (double &one : d)
            one /= 2. * h;
          return d;
        };
        const Mandel coarse = difference(2e-5), fine = difference(1e-5);
        for (unsigned int i = 0; i < 4; ++i)
          require_close(C[4 * i + j], (4. * fine[i] - coarse[i]) / 3., 2e-7 * metal.young_modulus(),
                        "the tangent " + std::to_string(i) + ", " + std::to_string(j));
      }
      point.solid(e);
      point.commit();
    }
    BOOST_TEST(point.committed.back() > 30.);
  };
  const std::vector<std::string> common = {"Material/Heat/Adiabatic=true", "Material/Heat/Heat capacity=.5"};
  for (const bool two_steps : {false, true})
  {
    for (const auto &rate : Registry<RateFactor>::names())
      for (const std::string softening : {"linear", "johnson-cook"})
        for (const std::string yield : {"mises", "hosford"})
          BOOST_TEST_CONTEXT(rate << ", " << softening << ", " << yield << (two_steps ? ", two steps" : ""))
          {
            std::vector<std::string> entries = common;
            for (const auto &more : {law_entries<YieldSurface>("Yield surface", yield),
                                     law_entries<RateFactor>("Rate factor", rate)})
              entries.insert(entries.end(), more.begin(), more.end());
            for (const auto &entry : law_entries<Softening>("Heat", softening))
              if (entry.find("/Law=") == std::string::npos)
                entries.push_back(entry);
            entries.push_back("Material/Heat/Softening=" + softening);
            check(*make_material("elastoplastic", "voce", entries), two_steps);
          }
    check(*make_material("elastoplastic", "flow curves", common), two_steps);
  }
}

// Metal that conducts may be colder than at its start: the linear softening goes on, that of Johnson and Cook does not.
BOOST_AUTO_TEST_CASE(cooled_below_the_start)
{
  const std::vector<std::string> common = {"Material/Young's modulus=200e3", "Material/Poisson's ratio=.3",
                                           "Material/Hardening/Flow stress=100", "Material/Heat/Adiabatic=true",
                                           "Material/Heat/Heat capacity=1e9", "Material/Heat/Conductivity=40",
                                           "Material/Heat/Initial temperature=20"};
  const auto check = [&](std::vector<std::string> entries, const double expected) {
    entries.insert(entries.end(), common.begin(), common.end());
    const auto metal = make_material("elastoplastic", "perfectly plastic", entries);
    BOOST_TEST(metal->history_layout().to_string() ==
               "plastic_strain:tensor equivalent_plastic_strain:positive temperature_rise:scalar");
    BOOST_TEST(metal->heat().value().conductivity == 40.);
    MaterialPoint point(*metal, true);
    point.committed[5] = -50.;
    const Mandel t = point.solid({{0., 0., 0., .01}});
    BOOST_TEST_REQUIRE(point.status.good());
    require_close(mises(t), expected, 1e-6 * expected, "the flow stress of the cooled metal");
  };
  check({"Material/Heat/Softening=linear", "Material/Heat/Softening coefficient=2e-3"}, 110.);
  check({"Material/Heat/Softening=johnson-cook", "Material/Heat/Softening exponent=1.03",
         "Material/Heat/Melting temperature=1520"},
        100.);
}

BOOST_AUTO_TEST_CASE(what_is_refused)
{
  const auto refused = [](const std::string &law, const std::vector<std::string> &entries, const std::string &entry) {
    BOOST_CHECK_EXCEPTION(rate_factor(law, entries), SceneError, [&](const SceneError &error) {
      return std::string(error.what()).find(entry) != std::string::npos;
    });
  };
  refused("cowper-symonds", {"Reference rate=0", "Rate exponent=5"}, "Reference rate");
  refused("cowper-symonds", {"Reference rate=40", "Rate exponent=.9"}, "Rate exponent");
  refused("johnson-cook", {"Rate coefficient=-.1", "Reference rate=1"}, "Rate coefficient");
  refused("power", {"Overstress=-1", "Rate exponent=2"}, "Overstress");
}

BOOST_AUTO_TEST_SUITE_END()
