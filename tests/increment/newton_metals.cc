// Newton's method is quadratic on shells and solids of every yield surface with every backstress and rate factor, with
// and without heat.
#include "../materials/drawn_metals.h"
#include "shell_problem.h"

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  constexpr double young = 69004.; ///< of the drawn metals

  /// What increments of a blank show.
  struct Shown
  {
    unsigned int assessed = 0; ///< whose residuals have something to tell
    unsigned int quadratic = 0;
    double flow = 0; ///< largest growth of the plastic work, over volume and flow stress
  };

  /// Once the residual is small, is each the square of the one before, times a bounded factor, down to round-off? A
  /// tangent that is a thousandth off is told. Residuals, relative to the stiffness, are small where they are so beside
  /// @p yield_strain, and the factor is of the size of its inverse.
  void assess(const std::vector<double> &residuals, const double yield_strain, Shown &shown)
  {
    constexpr double round_off = 1e-12;
    const double small = .01 * yield_strain, factor = 30. / yield_strain;
    bool told = false, good = true;
    for (std::size_t k = 1; k + 1 < residuals.size(); ++k)
      if (residuals[k] < small)
      {
        told = told || residuals[k] > 1e3 * round_off;
        good = good && residuals[k + 1] <= std::fmax(factor * residuals[k] * residuals[k], round_off);
      }
    shown.assessed += told;
    shown.quadratic += told && good;
  }

  /// Pressed by the fluid increment by increment, to a deflection of some thicknesses, further in long increments, and
  /// less and more again.
  Shown press(ShellProblem &problem, const double pressure)
  {
    Shown shown;
    const double volume = .05 * problem.blank->initial_flow_stress();
    double last = 0., work = 0.;
    const auto increment = [&](const double time, const double share) {
      problem.blank->begin_increment(time - last, last > 0. ? 1. : 0.);
      last = time;
      NewtonResult newton = problem.increment(time, share * pressure);
      const double plastic = problem.blank->energy().plastic;
      shown.flow = std::fmax(shown.flow, (plastic - work) / volume);
      work = plastic;
      return newton;
    };
    for (unsigned int k = 1; k <= 6; ++k)
      increment(.1 * k, k / 6.);
    double time = .6;
    for (const double share : {1.05, 1.1, 1.15, 1., .8, .5, .8, 1.1, 1.2})
    {
      time += .1;
      const auto residuals = increment(time, share).residuals;
      assess(residuals, problem.blank->initial_flow_stress() / young, shown);
      BOOST_TEST_MESSAGE("residuals" << listed_residuals(residuals));
    }
    return shown;
  }

  void check_quadratic(const std::string &kind, const Entries &entries)
  {
    for (const auto &metal : metals_of_all_pairs(4))
    {
      if (kind == "solid" && metal.sheet_only)
        continue;
      BOOST_TEST_CONTEXT(kind << " of " << metal.name)
      {
        Entries all = entries + metal.entries;
        all = all + Entries{"Blank/Symmetry=plane strain", "Units=mm, N, MPa, s"};
        ShellProblem problem(all, {}, {}, kind);
        // A deflection of w makes the strain 2/3 w^2 and carries the pressure 2 w times stress and thickness.
        const double share = metal.name.find("perfectly plastic") != std::string::npos ? .015 : .03;
        const Shown shown = press(problem, share * problem.blank->initial_flow_stress());
        BOOST_TEST(shown.assessed >= 3u);
        BOOST_TEST(shown.flow >= 5e-4);
        // All but one, in whose last steps points begin or cease to flow
        BOOST_TEST(shown.quadratic + 1 >= shown.assessed, shown.quadratic << " of " << shown.assessed);
      }
    }
  }
} // namespace

BOOST_AUTO_TEST_SUITE(newton_metals)

BOOST_AUTO_TEST_CASE(shells)
{
  check_quadratic("shell", {"Blank/Elements=8", "Blank/Layers=5"});
}

BOOST_AUTO_TEST_CASE(solids)
{
  check_quadratic("solid", {"Blank/Elements=8", "Blank/Elements through thickness=2", "Blank/Degree=2"});
}

BOOST_AUTO_TEST_SUITE_END()
