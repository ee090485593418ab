// A program outside of the tree: a block of 10 by 5 with Young's modulus 1000 is pressed by a plate, increment by
// increment; no file is read or written. The force is 2000 times the travel, less what plate and bed penetrate.
#include <deltaform/scene/scene.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdio>

namespace
{
  const char *const text = R"(
subsection Blank
  set Kind = solid
  set Kinematics = small
  set Symmetry = plane strain
  set Points = 0 2.5; 10 2.5
  set Thickness = 5
  set Elements = 4
  set Elements through thickness = 2
end
subsection Material
  set Model = linear elastic
  set Young's modulus = 1000
  set Poisson's ratio = 0
end
subsection Tools
  set Names = plate, bed
  subsection plate
    set Shape = plate
    set Side = top
    set Position z = 5
    set Motion = 0.1*t
  end
  subsection bed
    set Shape = plate
    set Side = bottom
    set Position z = 0
  end
end
subsection Supports
  set Names = symmetry
  subsection symmetry
    set Boundary = start
    set Component = r
  end
end
subsection Contact
  set Allowed penetration = 1e-6*thickness
end
subsection Steps
  set Stages = press
  subsection press
    set End time = 1
  end
end
)";
}

int
main(int argc, char *argv[])
{
  using namespace deltaform;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  auto tree = ParameterTree::parse(text, "pressed block");
  Scene scene(tree);
  Timers timers;
  FormingProblem problem(scene.actors, *scene.linear_solver, timers);
  Newton newton(problem, problem.system(), *scene.newton, problem.scale(), problem.size(), timers);
  problem.begin_stage(scene.actors.stages.front());
  double error = 0;
  for (const double time : {.25, .5, .75, 1.})
  {
    problem.begin_increment(time);
    scene.actors.blank->begin_increment(1.);
    Vector q = problem.committed();
    const auto result = newton.solve(
      q, problem.prescribed(), problem.is_prescribed(), problem.committed(), problem.force_floor());
    if (!result.converged())
      return 1;
    problem.commit(q);
    const double force = std::abs(problem.tool_forces().front()[1]);
    std::printf("travel %g: force %g in %u iterations\n", problem.travel(0), force, result.iterations);
    error = std::max(error, std::abs(force - 2000. * problem.travel(0)) / force);
  }
  return error < 2e-4 ? 0 : 1;
}
