// What every material has to fulfil as far as its traits say so: registered ones, with every registered law, and
// composed ones that the program does not have. The first failure ends a test.
#include "material_cases.h"

#include <boost/math/tools/roots.hpp>

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double elastic_size = 2e-6, plastic_size = .05;

  /// Without and, if the law takes that, with the flow of the last increment.
  std::vector<bool> with_and_without_last_flow(const Material &material)
  {
    return material.two_steps() ? std::vector<bool>{false, true} : std::vector<bool>{false};
  }

  std::vector<ThirdDirection> modes(const Material &material)
  {
    std::vector<ThirdDirection> result;
    if (material.traits().strain_given)
      result.push_back(ThirdDirection::strain_given);
    if (material.traits().stress_given)
      result.push_back(ThirdDirection::stress_given);
    return result;
  }

  /// The tangent against differences of fourth order at @p e.
  void check_tangent(MaterialPoint &point, const Mandel &e, const ThirdDirection third, const double third_stress)
  {
    std::array<double, 16> C{};
    Mandel e_copy = e;
    const Mandel stress = point.update(e_copy, third, third_stress, C.data());
    BOOST_TEST_REQUIRE(point.status.good());
    const double E = point.material.young_modulus();
    for (unsigned int j = 0; j < 4; ++j)
    {
      if (third == ThirdDirection::stress_given && j == 2)
        continue;
      const double h = 1e-4 * (norm(e) < 1e-4 ? 1e-2 * elastic_size : 1e-3);
      const auto difference = [&](const double step) {
        Mandel plus = e, minus = e;
        plus[j] += step;
        minus[j] -= step;
        const Mandel t_plus = point.update(plus, third, third_stress),
                     t_minus = point.update(minus, third, third_stress);
        Mandel d = testing::difference(t_plus, t_minus);
        for (auto &component : d)
          component /= 2. * step;
        return d;
      };
      const Mandel coarse = difference(h), fine = difference(h / 2.);
      for (unsigned int i = 0; i < 4; ++i)
      {
        const double numerical = (4. * fine[i] - coarse[i]) / 3.;
        require_close(C[4 * i + j],
                      numerical,
                      1e-7 * E + 1e-14 * norm(stress) / h,
                      "the tangent " + std::to_string(i) + ", " + std::to_string(j) + ", by differences,");
      }
    }
    if (point.material.traits().symmetric_tangent)
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          require_close(C[4 * i + j],
                        C[4 * j + i],
                        1e-11 * E,
                        "the tangent " + std::to_string(i) + ", " + std::to_string(j) + ", transposed,");
    if (third == ThirdDirection::stress_given)
      for (unsigned int i = 0; i < 4; ++i)
        BOOST_TEST_REQUIRE((C[4 * i + 2] == 0. && C[8 + i] == 0.));
  }

  /// Elastic, plastic from zero, plastic from a history, unloading.
  void check_tangents_of_a_path(const Material &material,
                                std::mt19937 &generator,
                                const ThirdDirection third,
                                const double third_stress,
                                const bool last_flow)
  {
    const bool flows = material.history_size() > 0;
    MaterialPoint point(material, last_flow);
    check_tangent(point, random_strain(generator, elastic_size), third, 0.);
    const Mandel first = random_strain(generator, plastic_size);
    check_tangent(point, first, third, third_stress);
    Mandel e = first;
    point.update(e, third, third_stress);
    point.commit();
    Mandel second = random_strain(generator, plastic_size);
    check_tangent(point, second, third, third_stress);
    if (flows)
      BOOST_TEST_REQUIRE(point.equivalent_plastic_strain() >
                         material.equivalent_plastic_strain(point.committed.data()));
    Mandel back = e; // a little of the elastic strain is taken back
    if (third == ThirdDirection::stress_given)
      back[2] = 0.;
    const Mandel plastic = material.plastic_strain(point.committed.data());
    for (const unsigned int i : {0, 1, 3})
      back[i] -= .2 * (e[i] - plastic[i]);
    if (third == ThirdDirection::strain_given)
      back[2] -= .2 * (e[2] - plastic[2]);
    check_tangent(point, back, third, third_stress);
    // What flows fast goes on for a while, more slowly; a backstress may be larger than the yield surface.
    if (flows && !point.material.traits().needs_duration && point.material.traits().isotropic_hardening)
      BOOST_TEST_REQUIRE(point.equivalent_plastic_strain() ==
                         material.equivalent_plastic_strain(point.committed.data()));
  }

  Mandel rotated(const Mandel &a, const double angle)
  {
    const double c = std::cos(2. * angle), s = std::sin(2. * angle);
    const double mean = (a[0] + a[1]) / 2., d = (a[0] - a[1]) / 2., t = a[3] / std::sqrt(2.);
    const double d_new = c * d + s * t, t_new = c * t - s * d;
    return {{mean + d_new, mean - d_new, a[2], std::sqrt(2.) * t_new}};
  }

} // namespace

BOOST_AUTO_TEST_SUITE(material_conformance)

BOOST_AUTO_TEST_CASE(zero_strain_zero_stress)
{
  for_all_materials(
    [](const Material &material) {
      for (const auto third : modes(material))
      {
        MaterialPoint point(material);
        Mandel e{};
        BOOST_TEST_REQUIRE(norm(point.update(e, third)) == 0.);
        BOOST_TEST_REQUIRE(point.status.good());
        BOOST_TEST_REQUIRE(norm(e) == 0.);
        BOOST_TEST_REQUIRE(point.equivalent_plastic_strain() == 0.);
      }
    });
}

BOOST_AUTO_TEST_CASE(tangent)
{
  for_all_materials(
    [](const Material &material) {
      std::mt19937 generator(1);
      for (const bool last_flow : with_and_without_last_flow(material))
        for (const auto third : modes(material))
          for (const double third_stress : {0., -3.})
            for (unsigned int k = 0; k < 5; ++k)
              check_tangents_of_a_path(material, generator, third, third_stress, last_flow);
    });
}

BOOST_AUTO_TEST_CASE(rotation_in_the_plane)
{
  for_all_materials(
    [](const Material &material) {
      if (material.traits().symmetry == Symmetry::orthotropic)
        return;
      std::mt19937 generator(2);
      for (const bool last_flow : with_and_without_last_flow(material))
        for (const auto third : modes(material))
          for (const double angle : {.3, 1.1, -2.})
          {
            MaterialPoint point(material, last_flow), turned(material, last_flow);
            for (unsigned int step = 0; step < 4; ++step)
            {
              Mandel e = random_strain(generator, plastic_size), e_turned = rotated(e, angle);
              const Mandel expected = rotated(point.update(e, third, 2.), angle);
              const Mandel stress = turned.update(e_turned, third, 2.);
              require_close(stress, expected, 1e-12 * norm(stress), "the stress in turned axes");
              require_close(e[2], e_turned[2], 1e-14, "the third strain in turned axes");
              point.commit();
              turned.commit();
            }
          }
    });
}

BOOST_AUTO_TEST_CASE(isotropic_in_all_directions)
{
  for_all_materials(
    [](const Material &material) {
      const auto traits = material.traits();
      if (traits.symmetry != Symmetry::isotropic || !traits.strain_given)
        return;
      // without shear the directions are alike
      const Mandel e{{.03, -.01, .004, 0.}}, permuted{{.004, .03, -.01, 0.}};
      MaterialPoint point(material), other(material);
      const Mandel t = point.solid(e), expected{{t[2], t[0], t[1], 0.}};
      require_close(other.solid(permuted), expected, 1e-12 * norm(t), "the stress with directions permuted");
    });
}

BOOST_AUTO_TEST_CASE(rollback_and_starting_guess)
{
  for_all_materials(
    [](const Material &material) {
      std::mt19937 generator(3);
      constexpr double infinity = std::numeric_limits<double>::infinity();
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      for (const auto third : modes(material))
      {
        for (const bool last_flow : with_and_without_last_flow(material))
        {
          MaterialPoint point(material, last_flow);
          for (unsigned int step = 0; step < 10; ++step)
          {
            Mandel e = random_strain(generator, plastic_size / 2.);
            const Mandel e_asked = e;
            const auto committed = point.committed;
            const Mandel expected = point.update(e, third, 1.);
            const auto trial = point.trial;
            BOOST_TEST_REQUIRE((point.committed == committed));
            // Whatever the trial values are, the answer is the same.
            for (const double garbage : {0., 1e-300, 1e-12, 1e-3, .1, 10., 1e300, -1., infinity, nan})
            {
              point.trial.assign(material.history_size(), garbage);
              Mandel e_again = e_asked;
              const Mandel stress = point.update(e_again, third, 1.);
              BOOST_TEST_CONTEXT("starting from " << garbage)
              {
                BOOST_TEST_REQUIRE(point.status.good());
                require_close(stress, expected, 1e-12 * norm(expected), "the stress");
                for (const auto &field : material.history_layout().fields())
                  for (std::size_t i = field.first; i < field.first + field.size(); ++i)
                    require_close(point.trial[i],
                                  trial[i],
                                  field.unit == "1" ? 1e-14 : 1e-12 * (1. + norm(expected)),
                                  "the history of " + field.name);
              }
              BOOST_TEST_REQUIRE((point.committed == committed));
            }
            if (step % 2 == 1)
              point.commit();
          }
        }
      }
    });
}

BOOST_AUTO_TEST_CASE(stress_given_is_strain_given_with_the_third_strain_found)
{
  for_all_materials(
    [](const Material &material) {
      if (!material.traits().strain_given || !material.traits().stress_given)
        return;
      std::mt19937 generator(4);
      for (const double third_stress : {0., -5., 40.})
      {
        MaterialPoint plane(material), solid(material);
        for (unsigned int step = 0; step < 5; ++step)
        {
          Mandel e = random_strain(generator, step < 2 ? 1e-3 : plastic_size);
          const Mandel stress = plane.update(e, ThirdDirection::stress_given, third_stress);

          const auto third_stress_at = [&](const double e3) {
            return solid.solid({{e[0], e[1], e3, e[3]}})[2] - third_stress;
          };
          std::uintmax_t n_iterations = 200;
          const auto bracket = boost::math::tools::toms748_solve(
            third_stress_at, -2., 2., boost::math::tools::eps_tolerance<double>(53), n_iterations);
          const double e3 = (bracket.first + bracket.second) / 2.;
          const Mandel expected = solid.solid({{e[0], e[1], e3, e[3]}});
          require_close(e[2], e3, 1e-10 * norm(e), "the third strain");
          require_close(stress, expected, 1e-10 * norm(stress), "the stress");
          require_close(plane.equivalent_plastic_strain(),
                        solid.equivalent_plastic_strain(),
                        1e-12,
                        "the equivalent plastic strain");
          plane.commit();
          solid.commit();
        }
      }
    });
}

BOOST_AUTO_TEST_CASE(dissipation_and_isochoric_flow)
{
  for_all_cases(
    [](const MaterialCase &one) {
      const Material &material = *one.material;
      std::mt19937 generator(5);
      for (const auto third : modes(material))
        for (const double size : {1e-4, 1e-3, 1e-2, 1.})
        {
          MaterialPoint point(material);
          for (unsigned int step = 0; step < 50; ++step)
          {
            Mandel e = random_strain(generator, size);
            const Mandel stress = point.update(e, third, step % 3 - 1.);
            BOOST_TEST_REQUIRE(point.status.good());
            const Mandel before = material.plastic_strain(point.committed.data());
            const Mandel now = material.plastic_strain(point.trial.data());
            const Mandel flow = difference(now, before);
            require_close(
              now[0] + now[1] + now[2], 0., 1e-13 * (norm(now) + norm(before)), "the volume of the plastic strain");
            const double equivalent = point.equivalent_plastic_strain();
            const double increment = equivalent - material.equivalent_plastic_strain(point.committed.data());
            BOOST_TEST_REQUIRE(increment >= 0.);
            // Work conjugacy of the equivalent plastic strain: the work of the flow is that of the flow stress.
            if (material.traits().isotropic_hardening && increment > 0.)
            {
              const double yield = material.flow_stress(point.trial.data());
              require_close(scalar_product(stress, flow),
                            yield * increment,
                            1e-12 * yield * equivalent + 1e-14 * norm(stress) * norm(now),
                            "the plastic work");
            }
            // For Mises |d e_p| sqrt(2/3) is its increment.
            if (one.mises)
              require_close(
                std::sqrt(2. / 3.) * norm(flow), increment, 1e-12 * equivalent, "the length of the plastic strain");
            point.commit();
          }
        }
    });
}

BOOST_AUTO_TEST_CASE(elastic_energy_is_the_work_of_elastic_loading)
{
  for_all_materials(
    [](const Material &material) {
      std::mt19937 generator(6);
      for (const auto third : modes(material))
      {
        MaterialPoint point(material);
        Mandel e = random_strain(generator, elastic_size);
        const Mandel stress = point.update(e, third, .03);
        const double work = scalar_product(stress, e) / 2.;
        require_close(material.elastic_energy(stress), work, 1e-13 * work, "the elastic energy");
        BOOST_TEST_REQUIRE(material.elastic_energy({}) == 0.);
        require_close(material.elastic_strain(stress), e, 1e-13 * elastic_size, "the elastic strain");
      }
    });
}

BOOST_AUTO_TEST_CASE(strains_that_are_not_finite_shorten_the_step)
{
  for_all_materials(
    [](const Material &material) {
      for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        for (const auto third : modes(material))
          for (const unsigned int component : {0, 1, 2, 3})
          {
            if (third == ThirdDirection::stress_given && component == 2)
              continue;
            std::array<Mandel, 3> strain{}, stress{};
            strain[1][component] = bad;
            const std::array<double, 3> third_stress{};
            std::vector<double> committed(3 * material.history_size(), 0.), trial(committed), predictor(committed);
            MaterialBatch batch;
            batch.n_points = 3;
            batch.third_direction = third;
            batch.strain = strain.data();
            batch.third_stress = third_stress.data();
            batch.duration = 1.;
            batch.committed = committed.data();
            batch.predictor = material.two_steps() ? predictor.data() : nullptr;
            batch.trial = trial.data();
            batch.stress = stress.data();
            const Status status = material.update(batch);
            BOOST_TEST_REQUIRE(!status.good());
            BOOST_TEST_REQUIRE(status.place == 1u);
          }
    });
}

BOOST_AUTO_TEST_CASE(moduli)
{
  for_all_materials(
    [](const Material &material) {
      const double E = material.young_modulus(), nu = material.poisson_ratio();
      require_close(material.shear_modulus(), E / (2. * (1. + nu)), 1e-14 * E, "the shear modulus");
      // Uniaxial stress
      const double e = elastic_size;
      for (const auto third : modes(material))
      {
        MaterialPoint point(material);
        Mandel strain{{e, -nu * e, -nu * e, 0.}};
        const Mandel expected{{E * e, 0., 0., 0.}};
        require_close(point.update(strain, third), expected, 1e-14 * E * e, "the stress of a bar");
      }
    });
}

BOOST_AUTO_TEST_SUITE_END()
