#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/text.h>
#include <deltaform/process/journal.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>

namespace deltaform
{
  namespace
  {
    /// A longer line would wrap, and only its last part be rewritten.
    std::string fit_to_terminal(const std::string &line)
    {
      winsize size = {};
      const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
      std::size_t space = known ? size.ws_col - 1u : 79u;
      std::size_t bytes = 0;
      while (bytes < line.size())
      {
        const bool begins_character = (static_cast<unsigned char>(line[bytes]) & 0xc0u) != 0x80u;
        if (begins_character && space-- == 0)
          break;
        ++bytes;
      }
      return line.substr(0, bytes);
    }
  } // namespace

  Journal::Journal(const Console console)
    : Journal(console, std::cout, std::cerr)
  {
    if (console == Console::automatic && isatty(STDOUT_FILENO) != 0)
      console_ = Console::terminal;
  }

  Journal::Journal(const Console console, std::ostream &out, std::ostream &warnings)
    : console_(console == Console::automatic ? Console::plain : console), out_(out), warnings_(warnings)
  {
  }

  Journal::~Journal()
  {
    finish_progress();
  }

  void Journal::open_log(const std::string &path, const bool append)
  {
    if (console_ == Console::silent)
      return;
    log_.open(path, append ? std::ios::app : std::ios::out);
    if (!log_)
      throw SceneError("Cannot write '" + path + "': " + std::strerror(errno) + ".");
    for (const auto &line : before_log_)
      log_ << line << '\n';
    before_log_.clear();
    log_.flush();
  }

  bool Journal::wants_progress() const
  {
    if (console_ == Console::terminal && progress_shown_)
      return std::chrono::steady_clock::now() - last_progress_ > std::chrono::milliseconds(50);
    return console_ != Console::quiet && console_ != Console::silent;
  }

  void Journal::progress(const std::string &text)
  {
    const std::string line = deltaform::text::printable(text);
    if (console_ == Console::terminal)
    {
      last_progress_ = std::chrono::steady_clock::now();
      out_ << "\r\033[K" << fit_to_terminal(line) << std::flush;
      progress_shown_ = true;
    }
    else if (console_ == Console::plain)
      out_ << line << std::endl;
  }

  void Journal::note(const std::string &text)
  {
    const std::string line = deltaform::text::printable(text);
    log(line);
    if (console_ == Console::quiet || console_ == Console::silent)
      return;
    erase_progress();
    out_ << line << std::endl;
  }

  void Journal::warning(const std::string &text)
  {
    const std::string line = "warning: " + deltaform::text::printable(text);
    ++n_warnings_;
    log(line);
    if (console_ == Console::silent)
      return;
    erase_progress();
    warnings_ << line << std::endl;
  }

  void Journal::detail(const std::string &text)
  {
    log(deltaform::text::printable(text));
  }

  void Journal::finish_progress()
  {
    if (progress_shown_)
      out_ << std::endl;
    progress_shown_ = false;
  }

  unsigned int Journal::n_warnings() const
  {
    return n_warnings_;
  }

  void Journal::log(const std::string &line)
  {
    if (log_.is_open())
      log_ << line << std::endl;
    else
      before_log_.push_back(line);
  }

  void Journal::erase_progress()
  {
    if (progress_shown_)
      out_ << "\r\033[K" << std::flush;
    progress_shown_ = false;
  }
} // namespace deltaform
