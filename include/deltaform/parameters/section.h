#pragma once

#include <deltaform/parameters/range.h>
#include <deltaform/parameters/time_function.h>

#include <memory>
#include <string>
#include <vector>

namespace deltaform
{
  class ParameterTree;

  /// Default of an entry, or the statement that there is none (`required`), with an example for the documentation and
  /// tests.
  template <typename T>
  struct Default
  {
    T value;
    bool required = false;
    Default(T v)
      : value(std::move(v))
    {
    }
    Default(T v, const bool is_required)
      : value(std::move(v)), required(is_required)
    {
    }
    /// So that a literal is a default, without the detour by std::string.
    template <std::size_t n>
    Default(const char (&literal)[n])
      : value(literal)
    {
    }
  };

  inline Default<double> required(const double example)
  {
    return {example, true};
  }
  inline Default<std::string> required(const std::string &example)
  {
    return {example, true};
  }

  /**
   * One subsection of a scene. Each call declares an entry (name, default, range, unit, sentence) and returns its
   * value, so that a parameter is stated once. A required entry has no default, only an example. Values come from the
   * scene file and from --set; an error names file, line, entry and what is allowed (SceneError, exit status 1). Units
   * are written as dimensions: "length", "stress", "force", "time", "1" ... and shown as such.
   */
  class Section
  {
  public:
    Section(ParameterTree &tree, std::vector<std::string> path);

    /// The whole scene.
    Section root() const
    {
      return Section(*tree_, {});
    }

    /// A section inside this one.
    Section sub(const std::string &name) const;

    double number(const std::string &name,
                  const Default<double> &value,
                  const Range &range,
                  const std::string &unit,
                  const std::string &sentence);
    int integer(const std::string &name, int value, int smallest, int largest, const std::string &sentence);
    bool flag(const std::string &name, bool value, const std::string &sentence);
    std::string text(const std::string &name, const Default<std::string> &value, const std::string &sentence);
    std::string choice(const std::string &name,
                       const std::string &value,
                       const std::vector<std::string> &choices,
                       const std::string &sentence);

    /// Names separated by commas.
    std::vector<std::string> names(const std::string &name, const std::string &value, const std::string &sentence);

    /// Names of subsections, which also become parts of columns and file names. They have no '/' and no control
    /// characters.
    std::vector<std::string>
    section_names(const std::string &name, const std::string &value, const std::string &sentence);

    /// Numbers separated by commas.
    std::vector<double>
    numbers(const std::string &name, const std::string &value, const std::string &unit, const std::string &sentence);

    /// Points "a b; c d; ...": rows of @p columns numbers separated by semicolons.
    std::vector<std::vector<double>> rows(const std::string &name,
                                          const Default<std::string> &value,
                                          unsigned int columns,
                                          const std::string &unit,
                                          const std::string &sentence);

    /// A function of time: a muParser expression in t (and @p constants), or a table "0: 0, 1: 1.2" with linear
    /// interpolation.
    TimeFunction function(const std::string &name,
                          const Default<std::string> &value,
                          const std::string &unit,
                          const std::string &sentence,
                          const std::map<std::string, double> &constants = {});

    /// Does the scene (file or --set) state this entry itself?
    bool given(const std::string &name) const;

    /// Is this the documentation tree, in which required entries take their examples?
    bool documentation() const;

    /// Throw a SceneError about the entry @p name, with file and line where it was set.
    [[noreturn]] void fail(const std::string &name, const std::string &message) const;

    /// The last element of the path, for messages: the tool's name in Tools/<name>.
    const std::string &title() const;

    /// "Tools/punch".
    std::string path() const;

  private:
    /// Can the numbers that the scene gives to an entry be computed with? @throws SceneError
    void check_magnitudes(const std::string &name, const std::vector<double> &values, bool are_sizes,
                          const std::string &unit) const;

    ParameterTree *tree_;
    std::vector<std::string> path_;
  };
} // namespace deltaform
