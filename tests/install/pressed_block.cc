// A program outside of the tree: a block of 10 by 5 with Young's modulus 1000 is pressed by a plate, increment by
// increment; no file is read or written. The force is 2000 times the travel, less what plate and bed penetrate.
#include <deltaform/materials/hardening_laws.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/scene/scene.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
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
  set Allowed penetration = 1e-6*edge
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
  Journal journal(Journal::Console::quiet);
  Timers timers;
  Analysis analysis(scene.actors, scene.analysis_settings(), journal, timers);
  double error = 0; // of the force
  std::printf("a law without a scene: flow stress %g\n", Swift{589., 1e-4, .216}(.1).value);
  analysis.begin();
  while (analysis.advance())
  {
    const double travel = analysis.model().travel(0), force = std::abs(analysis.model().tool_forces().front()[1]);
    std::printf("time %g: travel %g, force %g\n", analysis.time(), travel, force);
    error = std::max(error, std::abs(force - 2000. * travel));
  }
  const double allowed = 2000. * 2 * 5e-6; // both penetrate by 1e-6 of the thickness at most
  return analysis.end() == exit_status::done && error <= allowed ? 0 : 1;
}
