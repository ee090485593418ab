// The consistency equation from the smallest overshoot to a thousand times the flow stress, with flow curves that leave
// zero vertically.
#include "material_point.h"

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /**
   * In-plane shear is the same in plane strain and plane stress, and radial: with the trial stress q,
   * q - 3 G e_p = flow(e_p) and the stress is sqrt(2/3) flow(e_p) in Mandel's component. Both are checked on what comes
   * out, the committed plastic strain @p before. Of a flow curve that leaves zero so steeply that it rises by more than
   * round-off up to the smallest of numbers (K e^.02) no more can be asked than the foot of this step.
   */
  void shear(const Material &material, const Hardening &law, const double overshoot, const double before)
  {
    const double G = material.shear_modulus();
    for (const auto third : {ThirdDirection::strain_given, ThirdDirection::stress_given})
    {
      MaterialPoint point(material);
      if (before > 0.)
        point.committed = {0., 0., 0., std::sqrt(1.5) * before, before};
      const double flow_before = law.evaluate(before).value;
      const double first_rise = before > 0. ? 0. : law.evaluate(1e-300).value - flow_before;
      const double q = (flow_before > 0. ? flow_before : 100.) * (1. + overshoot);
      Mandel strain{{0., 0., 0., std::sqrt(1.5) * before + q / (std::sqrt(6.) * G)}};
      std::array<double, 16> C{};
      const Mandel stress = point.update(strain, third, 0., C.data());
      BOOST_TEST(point.status.good());
      const double now = point.equivalent_plastic_strain();
      const double q_now = std::sqrt(1.5) * stress[3];
      const double flow_now = law.evaluate(now).value;
      // of the strain that goes in, and of the smallest numbers
      const double round_off = 3. * G * before * 1e-15 + first_rise;
      BOOST_TEST(q_now <= (1. + 1e-14) * flow_now + round_off);
      BOOST_TEST(std::abs(q - 3. * G * (now - before) - q_now) <= 1e-14 * q + round_off);
      if (now > before)
        BOOST_TEST(std::abs(q_now - flow_now) <= 1e-14 * flow_now + round_off);
      if (q > (1. + 1e-13) * flow_before + 100. * round_off)
        BOOST_TEST(now > before);
      for (const double entry : C)
        BOOST_TEST(std::isfinite(entry));
      // A slope that is not finite has an elastic tangent; any other one lies between 0 and elastic.
      BOOST_TEST(C[15] >= -1e-12 * G);
      BOOST_TEST(C[15] <= (1. + 1e-14) * 2. * G);
    }
  }

  void all_overshoots(const Material &material, const Hardening &law)
  {
    for (double overshoot = 1e-15; overshoot < 2e3; overshoot *= std::sqrt(10.))
      for (const double before : {0., 1e-12, 1e-4, .1, 2.})
        BOOST_TEST_CONTEXT("overshoot " << overshoot << " after plastic strain " << before)
    shear(material, law, overshoot, before);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(yielding)

BOOST_AUTO_TEST_CASE(every_hardening_law)
{
  for (const auto &name : laws_of_strain())
    for (const std::string young : {"300", "69004", "1e8"})
      BOOST_TEST_CONTEXT(name << ", E = " << young)
      {
        const auto material = make_material("elastoplastic", name, {"Material/Young's modulus=" + young});
        all_overshoots(*material, *make_hardening(name));
      }
}

BOOST_AUTO_TEST_CASE(vertical_flow_curves)
{
  const auto check = [](const std::string &name, const std::vector<std::string> &entries) {
    std::vector<std::string> overrides;
    for (const auto &entry : entries)
      overrides.push_back("Material/Hardening/" + entry);
    BOOST_TEST_CONTEXT(name << " " << entries[0] << " " << entries[1])
    all_overshoots(*make_material("elastoplastic", name, overrides), *make_hardening(name, entries));
  };
  for (const std::string n : {".02", ".05", ".1", ".25", ".5", ".9", "1"})
    BOOST_TEST_CONTEXT("exponent " << n)
    {
      for (const std::string initial : {"0", "1e-6", "100"})
        check("ludwik", {"Initial flow stress=" + initial, "Strength coefficient=500", "Hardening exponent=" + n});
      for (const std::string prestrain : {"0", "1e-12", "1e-6"})
        check("swift", {"Strength coefficient=500", "Prestrain=" + prestrain, "Hardening exponent=" + n});
      check("hockett-sherby",
            {"Initial flow stress=100", "Saturation stress=500", "Saturation rate=10", "Hardening exponent=" + n});
    }
  check("voce", {"Initial flow stress=0", "Saturation stress=500", "Saturation rate=1e6"});
  check("voce", {"Initial flow stress=100", "Saturation stress=500", "Saturation rate=1e4", "Linear modulus=1e7"});
}

BOOST_AUTO_TEST_CASE(general_directions_in_plane_stress)
{
  std::mt19937 generator(7);
  for (const auto &name : laws_of_strain())
    BOOST_TEST_CONTEXT(name)
    {
      const auto material = make_material("elastoplastic", name);
      const auto law = make_hardening(name);
      const double yield = law->evaluate(0.).value / material->young_modulus();
      for (double size = .5 * yield; size < 1e4 * yield; size *= 3.)
        for (unsigned int k = 0; k < 30; ++k)
        {
          MaterialPoint point(*material);
          Mandel strain = random_strain(generator, size);
          const Mandel stress = point.update(strain, ThirdDirection::stress_given, .1 * law->evaluate(0.).value);
          BOOST_TEST(point.status.good());
          const double plastic = point.equivalent_plastic_strain();
          const double flow = law->evaluate(plastic).value;
          BOOST_TEST(mises(stress) <= (1. + 1e-14) * flow);
          if (plastic > 0.)
            BOOST_TEST(std::abs(mises(stress) - flow) <= 1e-14 * flow);
        }
    }
}

// The first iteration of an increment in which a load goes back: strain and history are those that were committed. Half
// of the points lie outside of their yield surface by round-off; none may have a plastic tangent.
BOOST_AUTO_TEST_CASE(at_rest_after_flow)
{
  std::mt19937 generator(11);
  for (const std::string surface : {"mises", "hill"})
    for (const std::string hardening : {"perfectly plastic", "linear", "swift", "voce"})
      for (const auto third : {ThirdDirection::strain_given, ThirdDirection::stress_given})
        BOOST_TEST_CONTEXT(surface << ", " << hardening << ", third direction " << static_cast<int>(third))
        {
          const std::string own = "Material/Yield surface/";
          const auto material =
            make_material("elastoplastic", hardening, {own + "Law=" + surface, own + "r-bar=1.6"});
          const auto traits = material->traits();
          if (!(third == ThirdDirection::strain_given ? traits.strain_given : traits.stress_given))
            continue;
          const double yield = make_hardening(hardening)->evaluate(0.).value / material->young_modulus();
          unsigned int n_plastic = 0;
          for (const double size : {3. * yield, .03, .3})
            for (unsigned int k = 0; k < 50; ++k)
            {
              MaterialPoint point(*material), untouched(*material);
              const Mandel end = random_strain(generator, size);
              Mandel strain{};
              std::array<double, 16> elastic{}, tangent{};
              untouched.update(strain, third, 0., elastic.data());
              constexpr unsigned int n_increments = 8;
              for (unsigned int n = 1; n <= n_increments; ++n)
              {
                for (unsigned int i = 0; i < 4; ++i)
                  strain[i] = end[i] * n / n_increments;
                point.update(strain, third);
                point.commit();
              }
              if (material->equivalent_plastic_strain(point.committed.data()) == 0.)
                continue;
              ++n_plastic;
              point.update(strain, third, 0., tangent.data());
              const double before = material->equivalent_plastic_strain(point.committed.data());
              BOOST_TEST(point.equivalent_plastic_strain() == before);
              BOOST_TEST(tangent == elastic, boost::test_tools::per_element());
            }
          BOOST_TEST(n_plastic > 50u);
        }
}

BOOST_AUTO_TEST_SUITE_END()
