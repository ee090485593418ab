// Arguments, MPI, one command, one catch.
#include <deltaform/base/ranks.h>
#include <deltaform/base/scene_error.h>
#include <deltaform/scene/run.h>

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

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
  // Which processes a run has, and that they end together, is known only between the start and the end of MPI.
  std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
  const auto end = [](const int status, const std::string &message) {
    if (ranks::end_together(status, true, message))
      std::cerr << "deltaform: " << message << '\n';
    return status;
  };
  try
  {
    const auto command = CommandLine::parse(argc, argv);
    start_alone_unless_launched();
    mpi = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(argc, argv, 1);
    if (!ranks::first())
      std::cout.setstate(std::ios::failbit);
    const int status = run_command(command);
    ranks::end_together(status, false, "");
    return status;
  }
  catch (const UsageError &error)
  {
    return end(exit_status::wrong_usage, error.what());
  }
  catch (const SceneError &error)
  {
    return end(exit_status::wrong_scene, error.what());
  }
  catch (const std::exception &error)
  {
    return end(EXIT_FAILURE, std::string("an error of the program, please report it:\n") + error.what());
  }
}
