#pragma once

#include <chrono>
#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * What the program tells its user: on the console and in run.log. On a terminal, progress is one line that is
   * rewritten; in a pipe, plain lines. Notes and warnings also go to the log, which is flushed line by line; what is
   * said before the log is open is kept for it.
   */
  class Journal
  {
  public:
    enum class Console
    {
      automatic, ///< plain lines to a pipe, a rewritten line on a terminal
      plain, ///< lines even on a terminal
      terminal, ///< a rewritten line even in a pipe
      quiet, ///< warnings only
      silent ///< nothing at all: the processes other than the first of a parallel run
    };

    /// On standard output, warnings on standard error.
    explicit Journal(Console console = Console::automatic);

    /// On given streams, of which the first is no terminal unless @p console says so.
    Journal(Console console, std::ostream &out, std::ostream &warnings);

    ~Journal();
    Journal(const Journal &) = delete;
    Journal &operator=(const Journal &) = delete;

    /// Begin the log, or go on with the one there is; what has been said so far is written to it. @throws SceneError if
    /// it cannot be written.
    void open_log(const std::string &path, bool append = false);

    /// Is anybody to see where the run is? On a terminal not more often than can be read.
    bool wants_progress() const;

    /// Where the run is: replaces the previous progress on a terminal. Not in the log.
    void progress(const std::string &line);

    /// Something worth knowing, such as a cut-back and its cause.
    void note(const std::string &text);

    /// Something that may make the result doubtful. Opens with "warning: ". Shown even when quiet.
    void warning(const std::string &text);

    /// Only for the log.
    void detail(const std::string &text);

    /// Leave the last progress line on the terminal and go on below it.
    void finish_progress();

    unsigned int n_warnings() const;

  private:
    void log(const std::string &line);
    void erase_progress();

    Console console_;
    std::ostream &out_;
    std::ostream &warnings_;
    bool progress_shown_ = false;
    std::chrono::steady_clock::time_point last_progress_;
    std::ofstream log_;
    std::vector<std::string> before_log_;
    unsigned int n_warnings_ = 0;
  };
} // namespace deltaform
