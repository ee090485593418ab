// Plastic points of a sheet, for counting instructions (point_cost.py): point_cost "Section/Entry=value"...
#include <deltaform/materials/material.h>
#include <deltaform/materials/point_history.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <vector>

using namespace deltaform;

namespace
{
  constexpr unsigned int n_points = 40, n_increments = 20, n_iterations = 3;

  /// Strains of point @p p when @p share of the path is done: sheared, and between plane strain and equal strains; the
  /// last part turns to another ratio.
  Mandel strain(const unsigned int p, const double share)
  {
    const double angle = .9 * p / n_points - .1, turn = share > .6 ? .4 * (share - .6) : 0.;
    return {{.2 * share * std::cos(angle), .2 * (share * std::sin(angle) + turn), 0., .05 * share}};
  }

  /// Increments of 1 % of strain, each with iterations that come closer, as Newton's do; tangents each time.
  bool form(const Material &material)
  {
    PointHistory history(n_points, material.history_layout());
    std::vector<Mandel> e(n_points), stress(n_points);
    std::vector<double> tangent(16 * n_points), third_stress(n_points, -1.);
    for (unsigned int increment = 1; increment <= n_increments; ++increment)
    {
      for (unsigned int iteration = 0; iteration < n_iterations; ++iteration)
      {
        const double off = iteration + 1 < n_iterations ? .02 * std::pow(.05, iteration) : 0.;
        for (unsigned int p = 0; p < n_points; ++p)
          e[p] = strain(p, (increment - off) / n_increments);
        MaterialBatch batch;
        batch.n_points = n_points;
        batch.third_direction = ThirdDirection::stress_given;
        batch.strain = e.data();
        batch.third_stress = third_stress.data();
        batch.duration = 1.;
        batch.committed = history.committed(0);
        batch.trial = history.trial(0);
        batch.stress = stress.data();
        batch.tangent = tangent.data();
        if (!material.update(batch).good())
          return false;
      }
      history.commit();
    }
    return true;
  }
} // namespace

/// Found by its name: not to be inlined.
__attribute__((noinline)) bool
form_points(const Material &material)
{
  return form(material);
}

int
main(const int argc, const char *const *argv)
{
  try
  {
    ParameterTree tree = ParameterTree::parse("", "benchmark", std::vector<std::string>(argv + 1, argv + argc));
    Section section = tree.root().sub("Material");
    const auto material = Registry<Material>::make("elastoplastic", section);
    if (!form_points(*material))
      return 1;
    std::printf("%u\n", n_points * n_increments * n_iterations);
    return 0;
  }
  catch (const std::exception &error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
