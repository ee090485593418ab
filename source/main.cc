// Arguments, MPI, one command, one catch.
#include <deltaform/base/scene_error.h>
#include <deltaform/scene/run.h>

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <iostream>

namespace
{
  /// Opening a transport to processes that do not exist takes longer than a small run. Settings of the user prevail.
  void start_alone_unless_launched()
  {
    if (std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE") || std::getenv("PMIX_RANK"))
      return;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_btl", "self", 0);
    setenv("OMPI_MCA_pml", "ob1", 0);
    // Its folder in /tmp is shared by all runs of a user: one that ends may remove it while another starts.
    setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  }
} // namespace


int
main(int argc, char *argv[])
{
  using namespace deltaform;
  try
  {
    const auto command = CommandLine::parse(argc, argv);
    start_alone_unless_launched();
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    return run_command(command);
  }
  catch (const UsageError &error)
  {
    std::cerr << "deltaform: " << error.what() << '\n';
    return exit_status::wrong_usage;
  }
  catch (const SceneError &error)
  {
    std::cerr << "deltaform: " << error.what() << '\n';
    return exit_status::wrong_scene;
  }
  catch (const std::exception &error)
  {
    std::cerr << "deltaform: an error of the program, please report it:\n" << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
