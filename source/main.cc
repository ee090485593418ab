// Arguments, MPI, read, build, run, one catch.
#include <deltaform/base/command_line.h>
#include <deltaform/base/scene_error.h>
#include <deltaform/scene/simulation.h>

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <iostream>

int
main(int argc, char *argv[])
{
  using namespace deltaform;
  setenv("OMPI_MCA_ess_singleton_isolated","1",0);setenv("OMPI_MCA_btl","self",0);setenv("OMPI_MCA_pml","ob1",0);
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      const CommandLine command = CommandLine::parse(argc, argv);
      auto              tree    = ParameterTree::read(command.scene, command.sets);
      Scene             scene(tree);
      Journal           journal;
      Timers            timers;
      Recorder          recorder(scene, command.output, journal, timers);
      Simulation        simulation(scene, recorder, journal, timers);
      const int s= simulation.run();
      timers.write_json(std::cout);
      return s;
    }
  catch (const SceneError &error)
    {
      std::cerr << error.what() << std::endl;
      return exit_status::wrong_scene;
    }
}
