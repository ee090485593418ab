// Arguments, MPI, one command, one catch.
#include <deltaform/app/run.h>
#include <deltaform/app/sweep.h>
#include <deltaform/base/processes.h>
#include <deltaform/base/ranks.h>
#include <deltaform/base/scene_error.h>

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace
{
  using namespace deltaform;

  /// By mpirun or its like: this process is one of several, or could be.
  bool launched()
  {
    return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE") || std::getenv("PMIX_RANK");
  }


  /// Opening a transport to processes that do not exist takes longer than a small run. Settings of the user prevail.
  void start_alone_unless_launched()
  {
    if (launched())
      return;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_btl", "self", 0);
    setenv("OMPI_MCA_pml", "ob1", 0);
    // Its folder in /tmp is shared by all runs of a user: one that ends may remove it while another starts.
    setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  }


  /// @p action returns the exit status; an error is said, and becomes one.
  int guarded(const std::function<int()> &action)
  {
    const auto end = [](const int status, const std::string &message) {
      if (ranks::end_together(status, true, message))
        std::cerr << "deltaform: " << message << '\n';
      return status;
    };
    try
    {
      return action();
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


  int run_with_mpi(const CommandLine &command, int argc, char **argv)
  {
    start_alone_unless_launched();
    // Which processes a run has, and that they end together, is known only between the start and the end of MPI.
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    const ranks::Processes all(MPI_COMM_WORLD);
    return guarded([&]() {
      if (!ranks::first())
        std::cout.setstate(std::ios::failbit);
      const int status = run_command(command);
      ranks::end_together(status, false, "");
      return status;
    });
  }
} // namespace


int
main(int argc, char *argv[])
{
  return guarded([&]() {
    const auto command = CommandLine::parse(argc, argv);
    const auto run = [&](const CommandLine &own) { return run_with_mpi(own, argc, argv); };
    // A sweep copies its process before MPI is started in it; one that was launched is refused, by one process for all.
    if (command.command == CommandLine::Command::sweep && !launched())
      return run_sweep(command, run);
    return run(command);
  });
}
