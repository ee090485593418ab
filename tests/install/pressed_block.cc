// A program outside of the tree: a block of 10 by 5 with Young's modulus 1000 is pressed by a plate, increment by
// increment; no file is read or written. The force is 2000 times the travel, less what plate and bed penetrate.
#include <deltaform/app/mpi_session.h>
#include <deltaform/materials/hardening_laws.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/scene/scene.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

int
main(int argc, char *argv[])
{
  using namespace deltaform;
  const MpiSession mpi(argc, argv);
  auto tree = ParameterTree::parse("", "pressed block",
                                   {"Blank/Kind=solid", "Blank/Kinematics=small", "Blank/Symmetry=plane strain",
                                    "Blank/Points=0 2.5; 10 2.5", "Blank/Thickness=5", "Blank/Elements=4",
                                    "Blank/Elements through thickness=2", "Material/Model=linear elastic",
                                    "Material/Young's modulus=1000", "Material/Poisson's ratio=0",
                                    "Tools/Names=plate, bed", "Tools/plate/Shape=plate", "Tools/plate/Side=top",
                                    "Tools/plate/Position z=5", "Tools/plate/Motion=0.1*t", "Tools/bed/Shape=plate",
                                    "Tools/bed/Side=bottom", "Tools/bed/Position z=0", "Supports/Names=symmetry",
                                    "Supports/symmetry/Boundary=start", "Supports/symmetry/Component=r",
                                    "Contact/Allowed penetration=1e-6*edge", "Steps/Stages=press"});
  Scene scene(tree);
  Journal journal(Journal::Console::quiet);
  Timers timers;
  Analysis analysis(scene.actors, scene.analysis_settings(), journal, timers);
  double error = 0.; // of the force
  std::printf("a law without a scene: flow stress %g\n", Swift{589., 1e-4, .216}(.1).value);
  analysis.begin();
  while (analysis.advance())
  {
    const double travel = analysis.model().travel(0), force = std::abs(analysis.model().tool_forces().front()[1]);
    std::printf("time %g: travel %g, force %g\n", analysis.time(), travel, force);
    error = std::max(error, std::abs(force - 2000. * travel));
  }
  const double allowed = 2000. * 2. * 5e-6; // both penetrate by 1e-6 of the thickness at most
  return analysis.end() == exit_status::done && error <= allowed ? 0 : 1;
}
