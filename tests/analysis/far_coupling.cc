// A load may couple unknowns that share no cell: a spring between the two ends of a strip.
#include <deltaform/analysis/analysis.h>
#include <deltaform/loads/boundary_entries.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/scene/scene.h>

#include <boost/test/unit_test.hpp>

#include <sstream>

using namespace deltaform;

namespace
{
  /// A spring k between the ends along z, and one of the same stiffness between each end and the ground.
  class EndSprings : public Load
  {
  public:
    EndSprings(Section &section, const Blank &blank)
      : Load(section, blank, {"force/length^2", "Stiffness k as a function of time t."}), boundary_(blank.boundary())
    {
      EndSprings::renumber();
    }

    void add_couplings(dealii::DynamicSparsityPattern &pattern) const override
    {
      pattern.add(ends_[0], ends_[1]);
      pattern.add(ends_[1], ends_[0]);
    }

    void add(const Vector &q, const double value, AssemblyTarget &target) const override
    {
      const double start = q[ends_[0]], end = q[ends_[1]];
      const double tangent[] = {2. * value, -value, -value, 2. * value};
      const double residual[] = {value * (2. * start - end), value * (2. * end - start)};
      target.add(ends_, 2, target.wants_tangent() ? tangent : nullptr, residual);
    }

    void renumber() override
    {
      ends_[0] = boundary_.dofs("start", Component::z)[0];
      ends_[1] = boundary_.dofs("end", Component::z)[0];
    }

  private:
    const Boundary &boundary_;
    DofIndex ends_[2];
  };

  /// Iterations of the accepted increments.
  struct Iterations : public Observer
  {
    Iterations(unsigned int &the_sum, unsigned int &the_number)
      : sum(the_sum), number(the_number)
    {
    }

    void accepted(const AcceptedIncrement &increment) override
    {
      sum += increment.cost.iterations;
      number = increment.number;
    }

    unsigned int &sum, &number;
  };

  const LoadRegistry::Entry entry("end springs", "between both ends, and to the ground", make_as<EndSprings, Load>);
} // namespace

BOOST_AUTO_TEST_SUITE(far_coupling)

BOOST_AUTO_TEST_CASE(the_ends_of_a_strip_share_a_force)
{
  constexpr double E = 1e4, h = .02, L = 2., k = .01, F = 1e-6; // so small that the strip bends as in linear theory
  const std::vector<std::string> entries = {"Blank/Symmetry=plane strain",
                                            "Blank/Points=0 0; 2 0",
                                            "Blank/Thickness=.02",
                                            "Blank/Elements=64",
                                            "Material/Model=linear elastic",
                                            "Material/Young's modulus=1e4",
                                            "Material/Poisson's ratio=0",
                                            "Supports/Names=hold, start, end",
                                            "Supports/hold/Component=r",
                                            "Supports/start/Component=rotation",
                                            "Supports/end/Boundary=end",
                                            "Supports/end/Component=rotation",
                                            "Loads/Names=pull, springs",
                                            "Loads/pull/Kind=edge",
                                            "Loads/pull/Boundary=end",
                                            "Loads/pull/Component=z",
                                            "Loads/pull/Value=1e-6*t",
                                            "Loads/springs/Kind=end springs",
                                            "Loads/springs/Value=.01",
                                            "Steps/Stages=pull", "Solver/Extrapolate=false"};
  ParameterTree tree = ParameterTree::parse("", "test", entries);
  Scene scene(tree);
  std::ostringstream said;
  Journal journal(Journal::Console::silent, said, said);
  Timers timers;
  Analysis analysis(scene.actors, scene.analysis_settings(), journal, timers);
  unsigned int n_iterations = 0, n_increments = 0;
  analysis.add(std::make_unique<Iterations>(n_iterations, n_increments));
  BOOST_TEST(analysis.run() == exit_status::done, analysis.message());
  BOOST_TEST(n_iterations <= 2 * n_increments); // the tangent has all that it needs

  // The strip, guided at both ends, is a spring of 12 E I/L^3 beside that between them. n elements err by 1/n^2.
  const double between = k + 12. * E * h * h * h / 12. / (L * L * L);
  const Boundary &boundary = scene.actors.blank->boundary();
  const Vector &q = analysis.model().committed();
  const double start = q[boundary.dofs("start", Component::z)[0]], end = q[boundary.dofs("end", Component::z)[0]];
  BOOST_TEST(end == F * (k + between) / (k * (k + 2. * between)), boost::test_tools::tolerance(1e-3));
  BOOST_TEST(start == F * between / (k * (k + 2. * between)), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
