#include "directives.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace
{
  std::string replaced(std::string text, const std::string &what, const std::string &by)
  {
    for (std::size_t place = 0; (place = text.find(what, place)) != std::string::npos; place += by.size())
      text.replace(place, what.size(), by);
    return text;
  }


  /// The words of a directive, taken one by one.
  class Words
  {
  public:
    explicit Words(const std::string &text)
      : stream_(text)
    {
    }

    std::string next(const std::string &meaning)
    {
      std::string word;
      if (!(stream_ >> word))
        throw std::runtime_error(meaning + " is missing");
      return word;
    }

    void expect(const std::string &word)
    {
      if (next("'" + word + "'") != word)
        throw std::runtime_error("'" + word + "' is expected");
    }

    double number(const std::string &meaning)
    {
      return to_number(next(meaning), meaning);
    }

    static double to_number(const std::string &word, const std::string &meaning)
    {
      char *end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (end == word.c_str() || *end != '\0')
        throw std::runtime_error("'" + word + "' is no number (" + meaning + ")");
      return value;
    }

    /// Anything left but a remark in parentheses?
    bool followed_by(const std::string &word)
    {
      const auto place = stream_.tellg();
      std::string found;
      if (stream_ >> found && found == word)
        return true;
      stream_.clear();
      stream_.seekg(place);
      return false;
    }

    void end()
    {
      std::string found;
      if (stream_ >> found && found.front() != '(')
        throw std::runtime_error("cannot understand '" + found + "'");
    }

  private:
    std::istringstream stream_;
  };


  Check read_check(const std::string &text)
  {
    const auto colon = text.find(':');
    if (colon == std::string::npos)
      throw std::runtime_error("a colon is missing in front of the reference");
    Check check;
    check.text = text.substr(0, colon);
    Words what(check.text);
    check.file = what.next("the file");
    check.column = what.next("the column");
    check.select = what.next("first, last, max, min, maxabs or at");
    if (check.select == "at")
    {
      const auto place = what.next("'column=value'");
      const auto equal = place.find('=');
      if (equal == std::string::npos)
        throw std::runtime_error("'at' needs 'column=value'");
      check.at_column = place.substr(0, equal);
      check.at = Words::to_number(place.substr(equal + 1), "place");
    }
    else if (check.select != "first" && check.select != "last" && check.select != "max" && check.select != "min" &&
             check.select != "maxabs")
      throw std::runtime_error("'" + check.select + "' is none of first, last, max, min, maxabs, at");
    what.end();

    Words expected(text.substr(colon + 1));
    if (expected.followed_by("below"))
      check.kind = Check::Kind::below;
    else if (expected.followed_by("above"))
      check.kind = Check::Kind::above;
    check.reference = expected.number("reference");
    if (check.kind == Check::Kind::within)
    {
      expected.expect("within");
      check.tolerance = expected.number("tolerance");
      check.relative = expected.followed_by("relative");
    }
    expected.end();
    return check;
  }


  Comparison read_comparison(const std::string &text)
  {
    Comparison comparison;
    comparison.text = text;
    Words words(text);
    comparison.file = words.next("the file");
    words.expect("columns");
    std::istringstream names(words.next("names of columns, separated by commas"));
    std::string name;
    while (std::getline(names, name, ','))
      comparison.columns.push_back(name);
    if (words.followed_by("over"))
      comparison.over = words.next("column");
    words.expect("with");
    comparison.reference = words.next("the reference");
    words.expect("tolerance");
    comparison.tolerance = words.number("tolerance");
    comparison.relative = words.followed_by("relative");
    words.end();
    return comparison;
  }
} // namespace


Directives
Directives::read(const std::string &scene, const std::string &work)
{
  std::ifstream file(scene);
  if (!file)
    throw std::runtime_error("cannot read " + scene);
  std::vector<std::string> lines;
  std::string line, here;
  while (std::getline(file, line))
  {
    lines.push_back(line);
    if (line.find("# <-- here") != std::string::npos)
      here = scene + ":" + std::to_string(lines.size());
  }

  const auto expand = [&](const std::string &text) {
    if (text.find("{here}") != std::string::npos && here.empty())
      throw std::runtime_error("no line is marked with '# <-- here'");
    return replaced(replaced(replaced(text, "{here}", here), "{scene}", scene), "{work}", work);
  };
  Directives result;
  result.command = expand("'{scene}' --quiet --output '{work}'");
  bool anything = false;
  for (unsigned int i = 0; i < lines.size(); ++i)
  {
    std::istringstream words(lines[i]);
    std::string hash, keyword, rest;
    if (!(words >> hash >> keyword) || hash != "#")
      continue;
    std::getline(words >> std::ws, rest);
    try
    {
      if (keyword == "EXIT")
        result.exit_status = static_cast<int>(Words::to_number(rest, "exit status"));
      else if (keyword == "COMMAND")
        result.command = expand(rest);
      else if (keyword == "MESSAGE")
        result.messages.push_back(expand(rest));
      else if (keyword == "FILE")
        result.files.push_back(rest);
      else if (keyword == "CHECK")
        result.checks.push_back(read_check(rest));
      else if (keyword == "COMPARE")
        result.comparisons.push_back(read_comparison(expand(rest)));
      else
        continue;
      anything = true;
    }
    catch (const std::runtime_error &error)
    {
      throw std::runtime_error(scene + ":" + std::to_string(i + 1) + ": " + error.what());
    }
  }
  if (!anything)
    throw std::runtime_error(scene + " expects nothing: no CHECK, COMPARE, MESSAGE, FILE or EXIT in its comments");
  return result;
}
