#include <deltaform/app/mpi_session.h>
#include <deltaform/app/program.h>
#include <deltaform/app/run.h>
#include <deltaform/app/sweep.h>
#include <deltaform/io/result_error.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/interruption.h>
#include <deltaform/process/processes.h>
#include <deltaform/process/ranks.h>

#include <deal.II/base/multithread_info.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <new>
#include <string>

namespace deltaform
{
  namespace
  {
    /// @p action returns the exit status; an error is said, and becomes one.
    int guarded(const std::function<int()> &action)
    {
      const auto end = [](int status, const std::string &message) {
        // What a signal has made impossible is no fault of the scene.
        if (const int signal = interruption::signal(); signal != 0)
          status = exit_status::by_signal + signal;
        if (ranks::end_together(status, true, message))
          std::cerr << "deltaform: " << text::printable(message) << '\n';
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
      catch (const ResultError &error)
      {
        return end(exit_status::not_converged, error.what());
      }
      catch (const std::bad_alloc &)
      {
        return end(exit_status::wrong_scene,
                   "There is not enough memory for what the scene asks for: take fewer elements.");
      }
      catch (const std::exception &error)
      {
        return end(EXIT_FAILURE, std::string("an error of the program, please report it:\n") + error.what());
      }
    }


    int run_with_mpi(const CommandLine &command, int argc, char **argv)
    {
      // Which processes a run has, and that they end together, is known only between the start and the end of MPI.
      const MpiSession mpi(argc, argv);
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


  int run_program(int argc, char *argv[])
  {
    return guarded([&]() {
      const auto command = CommandLine::parse(argc, argv);
      const auto run = [&](const CommandLine &own) { return run_with_mpi(own, argc, argv); };
      // A process that was launched with others says things once for all of them: that takes MPI.
      if (MpiSession::launched())
        return run(command);
      switch (command.command)
      {
      case CommandLine::Command::run:
        return run(command);
      case CommandLine::Command::sweep:
        // It copies its process before MPI is started in it.
        return run_sweep(command, run);
      default:
        // Nothing is computed, so that MPI is not needed, nor what it takes to start it.
        dealii::MultithreadInfo::set_thread_limit(1);
        return run_command(command);
      }
    });
  }
} // namespace deltaform
