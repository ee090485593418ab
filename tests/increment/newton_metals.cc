// Newton's method is quadratic on shells and solids of every yield surface with every backstress, with rates and heat.
#include "../materials/drawn_metals.h"
#include "shell_problem.h"

using namespace deltaform;
using namespace deltaform::testing;

namespace
{
  /// Pressed by the fluid increment by increment, to a deflection of some thicknesses, more, and less again: orders of
  /// the increments. Not a number: converged before three residuals fell.
  std::vector<double> orders(ShellProblem &problem, const double pressure)
  {
    std::vector<double> result;
    double last = 0.;
    const auto increment = [&](const double time, const double share) {
      problem.blank->begin_increment(time - last, last > 0. ? 1. : 0.);
      last = time;
      return problem.increment(time, share * pressure);
    };
    for (unsigned int k = 1; k <= 6; ++k)
      increment(.1 * k, k / 6.);
    BOOST_TEST(problem.blank->energy().plastic > 0.);
    double time = .6;
    for (const double share : {1.03, 1.06, 1.09, 1.12, .9, .5, .1, .6, 1.1})
    {
      time += .1;
      const NewtonResult newton = increment(time, share);
      result.push_back(observed_order(newton.residuals, 1e-13));
      BOOST_TEST_MESSAGE("order " << result.back() << ":" << listed_residuals(newton.residuals));
    }
    return result;
  }

  void check_orders(const std::string &kind, const Entries &entries)
  {
    for (const auto &metal : drawn_metals(4))
    {
      if (kind == "solid" && metal.sheet_only)
        continue;
      BOOST_TEST_CONTEXT(kind << " of " << metal.name)
      {
        Entries all = entries + metal.entries;
        all = all + Entries{"Blank/Symmetry=plane strain", "Units=mm, N, MPa, s"};
        ShellProblem problem(all, {}, {}, kind);
        unsigned int assessed = 0, good = 0;
        // A deflection of w makes the strain 2/3 w^2 and carries the pressure 2 w times stress and thickness.
        const double share = metal.name.find("perfectly plastic") != std::string::npos ? .015 : .03;
        for (const double order : orders(problem, share * problem.blank->initial_flow_stress()))
          if (!std::isnan(order))
          {
            ++assessed;
            good += order >= 1.65; // residuals that fall from 1e-4 to round-off in three steps may show no more
          }
        BOOST_TEST(assessed >= 5u);
        // All but increments in whose last steps points begin or cease to flow
        BOOST_TEST(good + 2 >= assessed, good << " of " << assessed);
      }
    }
  }
} // namespace

BOOST_AUTO_TEST_SUITE(newton_metals)

BOOST_AUTO_TEST_CASE(shells)
{
  check_orders("shell", {"Blank/Elements=8", "Blank/Layers=5"});
}

BOOST_AUTO_TEST_CASE(solids)
{
  check_orders("solid", {"Blank/Elements=8", "Blank/Elements through thickness=2", "Blank/Degree=2"});
}

BOOST_AUTO_TEST_SUITE_END()
