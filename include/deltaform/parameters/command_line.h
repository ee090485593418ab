#pragma once

#include <deltaform/parameters/variation.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace deltaform
{
  /// The command line is wrong: exit status 64. The message is a sentence for the user.
  class UsageError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// The exit statuses of the program; part of its interface.
  namespace exit_status
  {
    constexpr int done = 0;
    constexpr int wrong_scene = 1;
    constexpr int not_converged = 2;
    constexpr int promise_broken = 3;
    constexpr int wrong_usage = 64;
    constexpr int by_signal = 128; ///< and the number of the signal

    /// Did a signal end it?
    constexpr bool interrupted(const int status)
    {
      return status > by_signal;
    }
  } // namespace exit_status

  /// What the user asks for.
  struct CommandLine
  {
    enum class Command
    {
      run,
      check, ///< build the scene and say what is wrong with it, compute nothing
      sweep, ///< one run per combination of the varied values
      forming_limit, ///< compute and draw the limit of the sheet of a scene
      new_scene, ///< write a scene from a template
      explain, ///< what is known of an entry
      list, ///< what can be chosen
      print_parameters, ///< of the scene, or of everything if no scene is named
      print_columns, ///< of history.csv
      version,
      help
    };

    static constexpr double infinity = std::numeric_limits<double>::infinity();

    Command command = Command::run;
    std::string scene; ///< file name; may be empty for the commands that need none
    std::vector<std::string> sets; ///< "Section/Entry=value", in order
    std::string output; ///< folder; empty: what the scene says
    bool quiet = false;
    bool resume = false;
    bool force = false; ///< take the folder of results although another run may write into it
    unsigned int jobs = 1; ///< runs of a sweep at a time
    double seconds = infinity; ///< a run of a sweep may take
    std::vector<Variation> variations; ///< of a sweep
    unsigned int samples = 0; ///< runs of a sweep that samples; 0: all combinations
    unsigned int seed = 1; ///< of the random numbers of a sweep that samples
    bool print = false; ///< the commands of a sweep instead of running them
    std::string svg; ///< file that --check draws the scene into; empty: none
    std::vector<std::string> words; ///< of new_scene and explain

    /// @param argv as in main, with the program's name first. @throws UsageError
    static CommandLine parse(int argc, const char *const *argv);

    /// What --help prints.
    static std::string help();
  };
} // namespace deltaform
