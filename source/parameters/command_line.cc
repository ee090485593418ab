#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/text.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    namespace po = boost::program_options;
    using Command = CommandLine::Command;
    using Strings = std::vector<std::string>;

    po::options_description known_options()
    {
      po::options_description options;
      auto add = options.add_options();
      add("set", po::value<Strings>()->composing());
      add("output", po::value<std::string>());
      add("vary", po::value<Strings>()->composing());
      add("jobs", po::value<int>());
      add("seconds", po::value<double>());
      add("samples", po::value<int>());
      add("seed", po::value<int>());
      add("svg", po::value<std::string>());
      for (const auto *const name : {"check", "resume", "force", "quiet", "print", "list", "print-parameters",
                                     "print-columns", "version", "help,h"})
        add(name, po::bool_switch());
      add("words", po::value<Strings>());
      return options;
    }

    po::variables_map read_options(const int argc, const char *const *const argv)
    {
      const auto options = known_options();
      po::positional_options_description words;
      words.add("words", -1);
      // No guessing of abbreviated options: a new option must not change the meaning of an old script.
      const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
      po::variables_map values;
      try
      {
        po::store(po::command_line_parser(argc, argv).options(options).positional(words).style(style).run(), values);
      }
      catch (const po::unknown_option &error)
      {
        Strings known;
        for (const auto &option : options.options())
          if (option->long_name() != "words")
            known.push_back("--" + option->long_name());
        const std::string unknown = error.get_option_name();
        const auto is_opening = [&unknown](const std::string &name) { return name.find(unknown) == 0; };
        const auto longer = std::find_if(known.begin(), known.end(), is_opening);
        throw UsageError("Unknown option '" + unknown + "'; the nearest known one is '" +
                         (longer != known.end() ? *longer : text::nearest(unknown, known)) + "'.");
      }
      catch (const po::error &error)
      {
        throw UsageError(std::string("The command line is wrong: ") + error.what() + ".");
      }
      return values;
    }

    template <typename T>
    T value_or(const po::variables_map &values, const std::string &name, const T &otherwise)
    {
      return values.count(name) > 0 ? values[name].as<T>() : otherwise;
    }

    /// What --vary says. @throws UsageError
    std::vector<Variation> read_variations(const Strings &texts, const bool intervals)
    {
      std::vector<Variation> result;
      for (const auto &text : texts)
        try
        {
          // Without samples "20:100" would be a table of one row, which nobody means.
          if (!intervals && Variation::read(text, true).interval)
            throw std::invalid_argument("an interval needs --samples N, and a range a step, \"first:last:step\"");
          result.push_back(Variation::read(text, intervals));
        }
        catch (const std::invalid_argument &error)
        {
          throw UsageError("--vary \"" + text + "\": " + error.what() + ".");
        }
      for (std::size_t i = 0; i < result.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
          if (result[i].entry == result[k].entry)
            throw UsageError("--vary \"" + result[i].entry + "\" is stated twice.");
      return result;
    }

    /// A number of at least 1.
    unsigned int count(const po::variables_map &values, const std::string &name, const int otherwise)
    {
      const int result = value_or(values, name, otherwise);
      if (result < 1)
        throw UsageError("--" + name + " needs a number of at least 1.");
      return static_cast<unsigned int>(result);
    }

    /// The options of a sweep, or that there are none.
    void read_sweep(CommandLine &line, const po::variables_map &values)
    {
      const bool sweep = line.command == Command::sweep;
      for (const auto *const name : {"vary", "jobs", "seconds", "samples", "seed"})
        if (!sweep && values.count(name) > 0)
          throw UsageError(std::string("--") + name + " goes with 'deltaform sweep SCENE.prm' only.");
      if (!sweep)
        return;
      if (values.count("samples") > 0)
        line.samples = count(values, "samples", 1);
      else if (values.count("seed") > 0)
        throw UsageError("--seed goes with --samples only.");
      line.seed = count(values, "seed", 1);
      line.variations = read_variations(value_or(values, "vary", Strings()), line.samples > 0);
      if (line.variations.empty())
        throw UsageError("A sweep needs --vary \"Section/Entry=value,value,...\".");
      line.jobs = count(values, "jobs", 1);
      double runs = line.samples > 0 ? line.samples : 1.;
      if (line.samples == 0)
        for (const auto &variation : line.variations)
          runs *= static_cast<double>(variation.values.size());
      if (runs > static_cast<double>(ceilings::sweep_runs))
        throw UsageError("The values of --vary make " + text::rounded(runs) + " runs; a sweep has at most " +
                         std::to_string(ceilings::sweep_runs) + ".");
      line.seconds = value_or(values, "seconds", CommandLine::infinity);
      if (!(line.seconds > 0))
        throw UsageError("--seconds needs a positive number.");
    }

    /// The commands that are words.
    CommandLine words_command(const po::variables_map &values, const Strings &words)
    {
      for (const auto &[name, value] : values)
      {
        // The switches of a program that was called without them are false.
        const bool given = !value.defaulted() && name != "words";
        if (given)
          throw UsageError("--" + name + " does not go with 'deltaform " + words.front() + "'.");
      }
      CommandLine line;
      line.command = words.front() == "new" ? Command::new_scene : Command::explain;
      line.words = {words.begin() + 1, words.end()};
      if (line.command == Command::explain && line.words.size() != 1)
        throw UsageError("explain needs one name: deltaform explain \"Tools/punch/Friction coefficient\".");
      return line;
    }

    /// "run", "chek": no name of a file, but perhaps meant for a command.
    bool command_word_like(const std::string &word)
    {
      return word.find_first_of("./") == std::string::npos;
    }

    /// The command that is the first of @p words, which is taken off; run if there is none.
    Command take_command(Strings &words)
    {
      const std::string first = words.empty() ? "" : words.front();
      const Command command = first == "sweep" ? Command::sweep : first == "fld" ? Command::forming_limit
                                                                                 : Command::run;
      if (command != Command::run)
        words.erase(words.begin());
      return command;
    }

    /// @param word the command that the line begins with; run: none
    Command chosen_command(const po::variables_map &values, const Command word)
    {
      const std::vector<std::pair<const char *, Command>> commands = {{"help", Command::help},
                                                                      {"version", Command::version},
                                                                      {"list", Command::list},
                                                                      {"print-parameters", Command::print_parameters},
                                                                      {"print-columns", Command::print_columns},
                                                                      {"check", Command::check}};
      Command command = word;
      std::string name = word == Command::sweep ? "sweep" : word == Command::forming_limit ? "fld"
                                                                                           : "";
      for (const auto &[option, meaning] : commands)
        if (values[option].as<bool>())
        {
          if (meaning == Command::help)
            return meaning;
          if (!name.empty())
            throw UsageError(name + " and --" + option + " exclude each other.");
          name = std::string("--") + option;
          command = meaning;
        }
      return command;
    }

    /// Switches that go with some commands only.
    void check_switches(const CommandLine &line, const bool has_svg)
    {
      const bool sweep = line.command == Command::sweep;
      if (line.resume && line.command != Command::run && !sweep)
        throw UsageError("--resume goes with a run or a sweep only.");
      if (line.print && !sweep)
        throw UsageError("--print goes with 'deltaform sweep SCENE.prm' only.");
      if (has_svg && (line.command != Command::check || line.svg.empty()))
        throw UsageError("--svg FILE goes with --check only.");
    }
  } // namespace

  CommandLine CommandLine::parse(const int argc, const char *const *const argv)
  {
    const auto values = read_options(argc, argv);
    Strings words = value_or(values, "words", Strings());
    if (!words.empty() && (words.front() == "new" || words.front() == "explain") && !values["help"].as<bool>())
      return words_command(values, words);
    const Command word = take_command(words);
    const bool sweep = word == Command::sweep;

    CommandLine line;
    line.command = chosen_command(values, word);
    line.sets = value_or(values, "set", Strings());
    line.output = value_or(values, "output", std::string());
    line.quiet = values["quiet"].as<bool>();
    line.resume = values["resume"].as<bool>();
    line.print = values["print"].as<bool>();
    line.svg = value_or(values, "svg", std::string());
    line.force = values["force"].as<bool>();
    if (line.command == Command::help)
      return line;

    for (const auto &text : line.sets)
      if (text.find('=') == std::string::npos || text.front() == '=')
        throw UsageError("--set \"" + text + "\": expected \"Section/Entry=value\".");
    if (values.count("output") > 0 && line.output.empty())
      throw UsageError("--output needs the name of a folder.");

    const bool computes = line.command == Command::run || sweep;
    const bool needs_scene = computes || line.command == Command::check || line.command == Command::forming_limit;
    const bool takes_scene = needs_scene || line.command == Command::print_parameters;
    if (words.empty() && needs_scene)
      throw UsageError("No scene is named: deltaform SCENE.prm, or deltaform --help.");
    if (words.size() > 1 && command_word_like(words.front()))
      throw UsageError("'" + words.front() +
                       "' is no command. A scene is run by deltaform SCENE.prm; commands are sweep, fld, new and "
                       "explain.");
    if (words.size() > (takes_scene ? 1u : 0u))
      throw UsageError("'" + words.back() + "' is one word too many.");
    if (!words.empty())
      line.scene = words.front();

    check_switches(line, values.count("svg") > 0);
    if (line.force && !computes)
      throw UsageError("--force goes with a run or a sweep only.");
    read_sweep(line, values);
    return line;
  }

  std::string CommandLine::help()
  {
    return R"(deltaform: forming of sheet and bulk metal with rigid tools, where you state how far the
blank may penetrate a tool and the program finds the penalty factors.

  deltaform SCENE.prm [options]             run a scene
  deltaform sweep SCENE.prm --vary ...      run it once per value
  deltaform fld SCENE.prm [options]         forming limit of its metal: fld.csv, fld.svg
  deltaform new cup my.prm ["name=value"]   write a scene to start from; 'deltaform new' lists what there is
  deltaform explain "Blank/Layers"          what an entry means: unit, range, default
  deltaform --list                          what can be chosen: materials, tools, rules, ...
  deltaform --print-parameters [SCENE.prm]  every entry with default, unit, range and meaning;
                                            of a scene: the scene completed by its defaults
  deltaform --print-columns                 every column of history.csv with unit and meaning
  deltaform --version | --help

Options of a run (of fld: the first two)
  --set "Section/Entry=value"  replace an entry of the scene; may be repeated, the last one counts
  --output FOLDER              write results to FOLDER instead of where the scene says
  --check                      only say whether the scene is right; compute nothing
  --svg FILE                   with --check: plot blank, tools and supports
  --resume                     go on from the last saved state in the output folder
  --force                      write into the folder although another run seems to
  --quiet                      print warnings and errors only

Options of a sweep (and --set, --output, --force, --quiet)
  --vary "Section/Entry=a,b,c" the values to run; with several --vary, all combinations;
                               values that contain commas: "Section/Entry=a;b;c",
                               semicolons: "Section/Entry={0 0; 1 1},{0 0; 2 1}";
                               first:last:step is a range, such as .05:.2:.05
  --samples N                  N runs instead of all combinations, by a Latin hypercube:
                               first:last is then an interval, such as .05:.2
  --seed N                     other random numbers for --samples (1)
  --jobs N                     runs at a time (1)
  --seconds N                  a run that takes longer is ended; its row says so (no limit)
  --resume                     go on with a sweep that was stopped: runs that have ended stay
  --print                      print the commands of the runs, one per line, and run nothing

Exit status
   0  done
   1  the scene is wrong (the message names file, line and entry)
   2  stopped: an increment was not solved, or the sheet is torn; what was computed is
      written and can be resumed
   3  the promise, penetration <= allowed penetration, could not be kept
  64  the command line is wrong
 128  and more: ended by signal number status - 128, for example 130 by Ctrl-C, 143 by kill;
      the state is saved, and can be resumed
  A sweep is done if all its runs are; else its status is the largest of theirs.

Examples
  deltaform prm/cup.prm --output output/cup
  deltaform prm/cup.prm --set "Contact/Allowed penetration=1e-4" --set "Blank/Elements=100"
  deltaform sweep prm/cup.prm --vary "Contact/Allowed penetration=1e-3,1e-5,1e-7" --jobs 2
)";
  }
} // namespace deltaform
