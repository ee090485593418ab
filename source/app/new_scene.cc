#include "scene_templates.h"

#include <deltaform/app/new_scene.h>
#include <deltaform/io/atomic_file.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/parameters/expression.h>
#include <deltaform/parameters/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    void list_templates(std::ostream &out)
    {
      out << "deltaform new KIND FILE.prm [\"name=value\" ...] writes a scene to start from; lengths in mm. Kinds:\n";
      for (const auto &one : scene_templates())
      {
        out << '\n'
            << fmt::format("{:<10}{}\n", one.name, one.sentence);
        for (const auto &size : one.sizes)
          out << fmt::format("  {:<18}{:<8}{}\n", size.name, size.value, size.meaning);
      }
    }

    const SceneTemplate &template_of(const std::string &kind)
    {
      std::vector<std::string> names;
      for (const auto &one : scene_templates())
      {
        names.push_back(one.name);
        if (one.name == kind)
          return one;
      }
      throw UsageError("There is no template '" + kind + "'; there are " + text::join(names, ", ") + ".");
    }

    /// The sizes of a template, with those of the user.
    std::map<std::string, std::string> sizes_of(const SceneTemplate &own, const std::vector<std::string> &assignments)
    {
      std::map<std::string, std::string> result;
      std::vector<std::string> names;
      for (const auto &size : own.sizes)
      {
        result[size.name] = size.value;
        names.push_back(size.name);
      }
      for (const auto &assignment : assignments)
      {
        const auto equals = assignment.find('=');
        const std::string name = text::trim(assignment.substr(0, equals));
        if (equals == std::string::npos)
          throw UsageError("'" + assignment + "': expected \"name=value\", for example \"" + names.front() + "=" +
                           own.sizes.front().value + "\".");
        if (result.count(name) == 0)
          throw UsageError("'" + name + "' is no size of '" + own.name + "'; the nearest is '" +
                           text::nearest(name, names) + "'.");
        const std::string value = text::trim(assignment.substr(equals + 1));
        double number = -1.;
        try
        {
          number = evaluate_number(value);
        }
        catch (const std::invalid_argument &)
        {
          // Said below.
        }
        const bool may_be_zero = name == "friction";
        if (!(number > 0. || (may_be_zero && number == 0.)))
          throw UsageError("'" + assignment + "': a number " + (may_be_zero ? "of at least 0" : "above 0") +
                           " is needed, without a unit and with a decimal point.");
        result[name] = text::format(number);
      }
      return result;
    }

    std::string variable(std::string name)
    {
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    }

    std::string filled(std::string text, const std::map<std::string, std::string> &values)
    {
      for (const auto &[name, value] : values)
      {
        const std::string gap = "{" + name + "}";
        for (auto at = text.find(gap); at != std::string::npos; at = text.find(gap, at + value.size()))
          text.replace(at, gap.size(), value);
      }
      return text;
    }
  } // namespace


  void new_scene(const std::vector<std::string> &words, std::ostream &out)
  {
    if (words.empty())
    {
      list_templates(out);
      return;
    }
    const SceneTemplate &own = template_of(words[0]);
    if (words.size() == 1)
      throw UsageError("new " + own.name + " needs the name of a file: deltaform new " + own.name + " my.prm.");
    const std::string &file = words[1];
    auto values = sizes_of(own, {words.begin() + 2, words.end()});
    Constants constants;
    for (const auto &[name, value] : values)
      constants[variable(name)] = evaluate_number(value);
    for (const auto &derived : own.derived)
      values[derived.name] = fmt::format("{:.6g}", evaluate_number(derived.expression, constants));
    values["file"] = file;
    values["stem"] = std::filesystem::path(file).stem().string();
    if (std::filesystem::exists(file))
      throw UsageError("'" + file + "' exists; it is not written over.");
    const std::string scene = filled(own.text, values);
    write_file_atomically(file, [&scene](std::ostream &stream) { stream << scene; });
    out << file << ": " << own.sentence << "\n  deltaform " << file << " --check\n  deltaform " << file << '\n';
  }
} // namespace deltaform
