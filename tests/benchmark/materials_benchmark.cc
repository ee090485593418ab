// Time per material point, by hardening law, for both questions about the third direction. Prints Markdown.
#include <deltaform/materials/material.h>
#include <deltaform/materials/point_history.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace deltaform;

namespace
{
  constexpr unsigned int n_points = 3500, batch_size = 7, n_repetitions = 200;

  std::unique_ptr<Material> make(const std::string &name, const std::vector<std::string> &entries)
  {
    ParameterTree tree = ParameterTree::parse("", "benchmark", entries);
    Section section = tree.root().sub("Material");
    return Registry<Material>::make(name, section);
  }

  /// What the trial values are when the points are updated.
  enum class Start
  {
    committed, ///< first iteration of an increment after a cut-back
    last_iteration ///< later iterations: strains have changed by one part in a thousand
  };

  /// Nanoseconds per point; strains of about @p size per component on a history of strains of that size.
  double measure(const Material &material, const ThirdDirection third, const double size, const Start start)
  {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(.5, 1.);
    std::vector<Mandel> strain(n_points), stress(n_points), last(n_points);
    std::vector<double> third_stress(n_points, -1.), tangent(16 * n_points);
    PointHistory history(n_points, material.history_layout());

    const auto update = [&](std::vector<Mandel> &e, const bool with_tangent) {
      Status status;
      for (unsigned int first = 0; first < n_points; first += batch_size)
      {
        MaterialBatch batch;
        batch.n_points = batch_size;
        batch.third_direction = third;
        batch.strain = &e[first];
        batch.third_stress = &third_stress[first];
        batch.committed = history.committed(first);
        batch.trial = history.trial(first);
        batch.stress = &stress[first];
        batch.tangent = with_tangent ? &tangent[16 * first] : nullptr;
        status.merge(material.update(batch));
      }
      if (!status.good())
        std::printf("%s\n", status.cause);
    };

    for (auto &e : strain)
      e = {{size * uniform(generator), .3 * size * uniform(generator), -1.3 * size * uniform(generator), 0.}};
    update(strain, false);
    history.commit();
    for (auto &e : strain)
      for (auto &component : e)
        component *= 1.1;
    history.rollback();
    last = strain;
    update(last, false);
    if (start == Start::last_iteration)
      for (auto &e : strain)
        for (auto &component : e)
          component *= 1.001;
    else
      history.rollback();
    const PointHistory before = history;

    double best = 1e300;
    for (unsigned int k = 0; k < n_repetitions; ++k)
    {
      history = before;
      const auto begin = std::chrono::steady_clock::now();
      update(strain, true);
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
      best = std::fmin(best, elapsed.count());
    }
    return 1e9 * best / n_points;
  }
} // namespace

int
main()
{
  std::printf(
    "ns per point with tangent      | strain given: elastic, cold, warm | stress given: elastic, cold, warm\n");
  const auto row = [](const std::string &title, const Material &material) {
    std::printf("%-30s", title.c_str());
    for (const auto third : {ThirdDirection::strain_given, ThirdDirection::stress_given})
      std::printf(" | %6.1f %6.1f %6.1f",
                  measure(material, third, 1e-6, Start::committed),
                  measure(material, third, 1e-2, Start::committed),
                  measure(material, third, 1e-2, Start::last_iteration));
    std::printf("\n");
  };
  const std::vector<std::string> elasticity = {"Material/Young's modulus=69004", "Material/Poisson's ratio=.3"};
  row("linear elastic", *make("linear elastic", elasticity));
  const std::vector<std::vector<std::string>> laws = {
    {"Law=perfectly plastic", "Flow stress=200"},
    {"Law=linear", "Initial flow stress=200", "Hardening modulus=300"},
    {"Law=swift", "Strength coefficient=589", "Prestrain=1e-4", "Hardening exponent=.216"},
    {"Law=voce", "Initial flow stress=100", "Saturation stress=400", "Saturation rate=10"},
    {"Law=table", "Flow curve=0 200; 0.02 262; 0.05 301; 0.1 339; 0.2 379; 0.5 438; 1 489"}};
  for (const auto &law : laws)
  {
    std::vector<std::string> entries = elasticity;
    for (const auto &entry : law)
      entries.push_back("Material/Hardening/" + entry);
    row(law.front(), *make("elastoplastic", entries));
  }
  return 0;
}
