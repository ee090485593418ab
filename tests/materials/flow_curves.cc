// Flow curves over strain, rate and temperature: what the rows say, and another law that they can say exactly.
#include "material_cases.h"

#include <deltaform/io/point_file.h>
#include <deltaform/materials/flow_curves.h>
#include <deltaform/materials/rate_factor.h>
#include <deltaform/parameters/scene_error.h>

#include <cstdio>
#include <fstream>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  using Rows = std::vector<std::vector<double>>;

  /// Linear in the strain, in log rate and in the temperature: s = (s0 + H e) (1 + C ln(rate/rate0)) (1 - rise/range).
  struct Product
  {
    double s0 = 200., H = 300., C = .05, rate0 = .01, start = 20., range = 1000.;

    double operator()(const double e, const double rate, const double temperature) const
    {
      return (s0 + H * e) * (1. + C * std::log(rate / rate0)) * (1. - (temperature - start) / range);
    }

    /// At rates from rate0 to 1e4 rate0 and temperatures from start to melting.
    Rows rows() const
    {
      Rows result;
      for (const double rate : {rate0, 1e4 * rate0})
        for (const double share : {0., .3, 1.})
          for (const double e : {0., .2, .7, 2., 5.})
          {
            const double temperature = start + share * range;
            result.push_back({rate, temperature, e, share < 1. ? (*this)(e, rate, temperature) : 0.});
          }
      return result;
    }
  };

  std::string text_of(const Rows &rows)
  {
    std::ostringstream text;
    text << std::setprecision(17);
    for (const auto &row : rows)
      text << (text.str().empty() ? "" : "; ") << row[0] << " " << row[1] << " " << row[2] << " " << row[3];
    return text.str();
  }

  const std::vector<std::string> adiabatic = {"Material/Heat/Adiabatic=true", "Material/Heat/Heat capacity=4"};

  std::unique_ptr<Material> by_curves(const Product &law, std::vector<std::string> more = {})
  {
    more.push_back("Material/Hardening/Flow curves=" + text_of(law.rows()));
    more.push_back("Material/Hardening/Initial temperature=" + std::to_string(law.start));
    return make_material("elastoplastic", "flow curves", more);
  }

  /// The same law from three others.
  std::unique_ptr<Material> by_factors(const Product &law, std::vector<std::string> more = {})
  {
    const auto number = [](const std::string &entry, const double value) {
      std::ostringstream text;
      text << "Material/" << entry << "=" << std::setprecision(17) << value;
      return text.str();
    };
    for (const auto &entry : {number("Hardening/Initial flow stress", law.s0),
                              number("Hardening/Hardening modulus", law.H),
                              std::string("Material/Rate factor/Law=johnson-cook"),
                              number("Rate factor/Rate coefficient", law.C),
                              number("Rate factor/Reference rate", law.rate0)})
      more.push_back(entry);
    return make_material("elastoplastic", "linear", more);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(flow_curves)

BOOST_AUTO_TEST_CASE(rows_are_met_and_interpolated)
{
  const Product law;
  const FlowCurves curves(law.rows());
  for (const auto &row : law.rows())
    require_close(curves(row[2], row[0], row[1]).value, row[3], 1e-10, "a row");
  for (const double e : {.05, .5, 1.7})
    for (const double rate : {.013, .7, 55.})
      for (const double temperature : {35., 300., 700., 1000.})
        require_close(curves(e, rate, temperature).value, law(e, rate, temperature), 1e-9, "between rows the stress");
  // Outside of the table: as at the nearest curve.
  require_close(curves(.3, 1e-5, 300.).value, law(.3, .01, 300.), 1e-9, "below the lowest rate");
  require_close(curves(.3, 0., 300.).value, law(.3, .01, 300.), 1e-9, "at rest");
  require_close(curves(.3, 1e5, 300.).value, law(.3, 100., 300.), 1e-9, "above the highest rate");
  require_close(curves(.3, 1., -50.).value, law(.3, 1., 20.), 1e-9, "below the lowest temperature");
  require_close(curves(.3, 1., 1500.).value, 0., 0., "above the melting temperature");
  require_close(curves(9., 1., 300.).value, law(5., 1., 300.), 1e-9, "beyond the last strain");
}

BOOST_AUTO_TEST_CASE(derivatives)
{
  const FlowCurves curves(Product().rows());
  const double h = 1e-4;
  for (const double e : {.05, .5, 7.})
    for (const double rate : {.001, .7, 55., 300.})
      for (const double temperature : {0., 100., 700., 1200.})
      {
        const auto at = curves(e, rate, temperature);
        const auto slope = [&](const double de, const double dr, const double dt) {
          const double after = curves(e + de, rate + dr, temperature + dt).value;
          return (after - curves(e - de, rate - dr, temperature - dt).value) / (2. * (de + dr + dt));
        };
        require_close(at.by_strain, slope(h, 0., 0.), 1e-5, "the slope in the strain");
        require_close(at.by_rate, slope(0., h * rate, 0.), 1e-5 * (1. + std::abs(at.by_rate)), "the slope in the rate");
        require_close(at.by_temperature, slope(0., 0., h), 1e-5, "the slope in the temperature");
      }
}

// The rows say a product of laws of which each has a test of its own.
BOOST_AUTO_TEST_CASE(same_as_a_product_of_laws)
{
  const Product law;
  auto heat = adiabatic;
  heat.insert(heat.end(), {"Material/Heat/Softening=linear", "Material/Heat/Softening coefficient=.001"});
  const auto expected = by_factors(law, heat), metal = by_curves(law, adiabatic);
  BOOST_TEST(metal->history_layout().to_string() == expected->history_layout().to_string());
  BOOST_TEST(metal->traits().needs_duration);
  MaterialPoint point(*metal, true), other(*expected, true);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> step(-.003, .003);
  for (int i = 0; i < 60; ++i)
  {
    point.duration = other.duration = i % 3 == 0 ? .01 : .3;
    Mandel e = {{i * .02 + step(generator), -i * .008 + step(generator), 0., step(generator)}}, same = e;
    std::array<double, 16> C{}, D{};
    const Mandel t = point.update(e, ThirdDirection::stress_given, 0., C.data());
    const Mandel s = other.update(same, ThirdDirection::stress_given, 0., D.data());
    BOOST_TEST_REQUIRE(point.status.good());
    BOOST_TEST_REQUIRE(other.status.good());
    require_close(t, s, 1e-9, "the stress");
    for (unsigned int k = 0; k < 16; ++k)
      require_close(C[k], D[k], 1e-5, "the tangent");
    point.commit();
    other.commit();
  }
  BOOST_TEST(point.committed.back() > 30.); // it has become warm
  require_close(point.committed.back(), other.committed.back(), 1e-9, "the rise of the temperature");
  // At rest the warm metal is soft, and slow.
  const double e = point.committed[4], rise = point.committed.back();
  require_close(metal->flow_stress(point.committed.data()), law(e, law.rate0, law.start + rise), 1e-9, "at rest");
  require_close(expected->flow_stress(other.committed.data()), law(e, law.rate0, law.start + rise), 1e-9, "at rest");
}

BOOST_AUTO_TEST_CASE(one_curve_knows_no_rate)
{
  const auto metal = make_material("elastoplastic",
                                   "flow curves",
                                   {"Material/Hardening/Flow curves=1 20 0 200; 1 20 .1 300; 1 20 .2 350; 1 20 1 400"});
  BOOST_TEST(!metal->traits().needs_duration);
  BOOST_TEST(metal->history_layout().to_string() == "plastic_strain:tensor equivalent_plastic_strain:positive");
}

// The same rows in a file are the same metal, to the last bit.
BOOST_AUTO_TEST_CASE(from_a_file)
{
  const Product law;
  const std::string name = "flow_curves_of_the_test.csv";
  const auto write = [&](const std::string &last) {
    std::ofstream file(name);
    file << "# measured\nrate, temperature, strain, stress\n"
         << std::setprecision(17);
    for (const auto &row : law.rows())
      file << row[0] << ", " << row[1] << ", " << row[2] << ", " << row[3] << "\n";
    file << last;
  };
  write("");
  std::vector<std::string> entries = {"Material/Hardening/File=" + name, "Material/Hardening/Flow curves=",
                                      "Material/Hardening/Initial temperature=20"};
  entries.insert(entries.end(), adiabatic.begin(), adiabatic.end());
  const auto expected = by_curves(law, adiabatic);
  const auto metal = make_material("elastoplastic", "flow curves", entries);
  BOOST_TEST((read_rows(name, 4) == law.rows()));
  std::vector<double> history(metal->history_size(), 0.);
  for (const double strain : {0., .03, .5, 3.})
    for (const double rise : {0., 170., 600.})
    {
      history[4] = strain;
      history.back() = rise;
      BOOST_TEST(metal->flow_stress(history.data()) == expected->flow_stress(history.data()));
    }
  const auto refused = [&](const std::string &words) {
    BOOST_CHECK_EXCEPTION(make_material("elastoplastic", "flow curves", entries), SceneError, [&](const auto &error) {
      BOOST_TEST_MESSAGE(error.what());
      const std::string text = error.what();
      return text.find(words) != std::string::npos && text.find("Hardening/File") != std::string::npos;
    });
  };
  write("100, 1020, 6\n");
  refused("line 33: '100  1020  6'");
  write("50, 1020, 6, 0\n");
  refused("not sorted");
  std::remove(name.c_str());
  refused("cannot be read");
  entries.push_back("Material/Hardening/Flow curves=" + text_of(law.rows()));
  refused("not both");
}

// From a virgin point, however long and fast the increment: at its end the yield condition is that of the product, and
// the heat that of its harmonic mean over the increment, at the rate since yield (doc/theory/materials.md, Heat).
BOOST_AUTO_TEST_CASE(first_increments)
{
  const Product law;
  const double heating = .9 / 4.;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> component(-1., 1.), exponent(-3., 0.), speed(-6., 6.);
  for (const bool hot : {false, true})
  {
    const auto metal = by_curves(law, hot ? adiabatic : std::vector<std::string>());
    for (const auto third : {ThirdDirection::strain_given, ThirdDirection::stress_given})
      for (int i = 0; i < 1000; ++i)
      {
        MaterialPoint point(*metal);
        point.duration = std::pow(10., speed(generator));
        const double size = std::pow(10., exponent(generator));
        Mandel e;
        for (double &one : e)
          one = size * component(generator);
        const Mandel t = point.update(e, third);
        BOOST_TEST_REQUIRE(point.status.good(), size << " in " << point.duration << ": " << point.status.cause);
        const double x = point.equivalent_plastic_strain();
        if (x == 0.)
          continue;
        const double rise = hot ? point.trial.back() : 0.;
        BOOST_TEST_REQUIRE(rise <= law.range);
        const auto clamped = [&](const double rate) { return std::fmin(std::fmax(rate, law.rate0), 1e4 * law.rate0); };
        const double expected = law(x, clamped(x / point.duration), law.start + rise);
        require_close(mises(t), expected, 1e-9 * law.s0, "the stress");
        double rate = x / point.duration;
        for (int repeated = 0; repeated < 2; ++repeated)
          rate = (x + law(0., clamped(rate), law.start) / (3. * metal->shear_modulus())) / point.duration;
        const double root = std::sqrt(6.);
        double cold = 0., over_hot = 0.;
        for (const auto &[c, w] : std::vector<std::pair<double, double>>{
               {(4. - root) / 10., (16. - root) / 36.}, {(4. + root) / 10., (16. + root) / 36.}, {1., 1. / 9.}})
        {
          const double at_start = law(c * x, clamped(rate), law.start);
          cold += w * at_start;
          over_hot += w * at_start / law(c * x, clamped(rate), law.start + c * rise);
        }
        require_close(rise, hot ? heating * x * cold / over_hot : 0., 1e-9 * law.range, "the rise of the temperature");
      }
  }
}

// A metal that is heated up to melting carries nothing, and heats no more.
BOOST_AUTO_TEST_CASE(melts_and_stays_so)
{
  const Product law{200., 300., .05, .01, 20., 100.};
  const auto metal = by_curves(law, adiabatic);
  MaterialPoint point(*metal);
  for (unsigned int i = 1; i <= 50; ++i)
  {
    const Mandel t = point.solid({{0., 0., 0., .1 * i}});
    BOOST_TEST_REQUIRE(point.status.good());
    BOOST_TEST_REQUIRE(mises(t) >= 0.);
    point.commit();
  }
  BOOST_TEST(point.committed.back() <= 100.);
  BOOST_TEST(point.committed.back() > 99.);
}

BOOST_AUTO_TEST_CASE(what_is_refused)
{
  const std::string good = "1 20 0 200; 1 20 .1 300; 1 20 .2 350; 1 20 1 400";
  const auto curve = [](const std::string &head, const std::string &factor) {
    return head + " 0 2" + factor + "; " + head + " .1 3" + factor + "; " + head + " .2 4" + factor + "; " + head +
           " 1 5" + factor;
  };
  const auto refused = [](const std::vector<std::string> &entries, const std::string &words) {
    std::vector<std::string> all;
    for (const auto &entry : entries)
      all.push_back("Material/" + entry);
    BOOST_CHECK_EXCEPTION(make_material("elastoplastic", "flow curves", all), SceneError, [&](const SceneError &error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).find(words) != std::string::npos;
    });
  };
  const auto rows = [&](const std::string &text, const std::string &words) {
    refused({"Hardening/Flow curves=" + text}, words);
  };
  rows("0 20 0 200; 0 20 .1 300; 0 20 .2 350; 0 20 1 400", "rate is not positive");
  rows(curve("1 20", "00") + "; " + curve(".1 20", "00"), "not sorted");
  rows(curve("1 200", "00") + "; " + curve("1 20", "00"), "not sorted");
  rows("1 20 0 200; 1 20 .2 300; 1 20 .1 350; 1 20 1 400", "does not increase");
  rows("1 20 0 200; 1 20 .1 300; 1 20 .2 -350; 1 20 1 400", "not positive");
  rows("1 20 0 200; 1 20 .1 300; 1 20 .2 250; 1 20 1 400", "monotone");
  rows("1 20 0 200; 1 20 .1 300; 1 20 1 400", "four rows");
  rows(curve("1 20", "00") + "; " + curve("1 300", "10"), "rises with the temperature");
  rows(curve("1 20", "10") + "; " + curve("2 20", "00"), "falls with the rate");
  rows(curve("1 20", "10") + "; " + curve("1 300", "00") + "; " + curve("2 20", "20"), "curve is missing");
  rows(curve("1 20", "10") + "; " + curve("2 20", "20") + "; " + curve("2 300", "10"), "same temperatures");
  rows("1 20 0 200; 1 20 .1 300; 1 20 .2 350", "at rate 1, temperature 20");
  refused({"Hardening/Flow curves=" + good + "; 1 300 0 0", "Hardening/Initial temperature=300"}, "molten");
  refused({"Rate factor/Law=power", "Rate factor/Overstress=50", "Rate factor/Rate exponent=2"}, "Rate factor/Law");
  refused({"Heat/Adiabatic=true", "Heat/Heat capacity=3", "Heat/Softening=linear", "Heat/Softening coefficient=.001"},
          "Heat/Softening");
  refused({"Heat/Adiabatic=true", "Heat/Heat capacity=3", "Heat/Softening=none", "Heat/Conductivity=20",
           "Heat/Initial temperature=25"},
          "Heat/Initial temperature");
  BOOST_CHECK_EXCEPTION(
    make_material("elastoplastic",
                  "sum",
                  {"Material/Hardening/First/Law=flow curves", "Material/Hardening/First/Flow curves=" + good,
                   "Material/Hardening/First/Initial temperature=20"}),
    SceneError,
    [](const SceneError &error) { return std::string(error.what()).find("no part of a sum") != std::string::npos; });
}

BOOST_AUTO_TEST_SUITE_END()
