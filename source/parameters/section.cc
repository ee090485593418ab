#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/expression.h>
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <stdexcept>

namespace deltaform
{
  namespace
  {
    /// What an expected piece of text should have been: the end of a complaint.
    std::string described(const Declaration &declaration)
    {
      const std::string unit = declaration.unit.empty() ? "" : " [" + declaration.unit + "]";
      return unit + (declaration.sentence.empty() ? "." : ". " + declaration.sentence);
    }

    /// Declare the entry and convert its value by @p convert, which throws std::invalid_argument if it cannot.
    template <typename Convert>
    auto
    read(ParameterTree &tree, const SectionPath &path, Declaration declaration, const Convert &convert)
    {
      declaration.check = [convert](const std::string &value) { convert(value); };
      const std::string text = tree.declare(path, declaration);
      try
      {
        return convert(text);
      }
      catch (const std::invalid_argument &error)
      {
        tree.fail(path, declaration.name, error.what() + described(declaration));
      }
    }

    /// Numbers separated by blanks. @throws std::invalid_argument
    std::vector<double> row_in(std::string piece)
    {
      std::vector<double> row;
      std::replace(piece.begin(), piece.end(), '\t', ' ');
      for (const auto &number : text::split(piece, ' '))
        if (!number.empty() && number.back() == ',')
          throw std::invalid_argument("'" + number + "': numbers of a row are separated by blanks, rows by semicolons");
        else if (!number.empty())
          row.push_back(evaluate_number(number));
      return row;
    }

    double number_in(const std::string &text, const Range &range)
    {
      double value = 0.;
      try
      {
        value = evaluate_number(text::unquoted(text));
      }
      catch (const std::invalid_argument &error)
      {
        const std::string bounds = " in " + range.to_string();
        throw std::invalid_argument(std::string(error.what()) + "; expected a number" + bounds);
      }
      if (!range.contains(value))
        throw std::invalid_argument("must lie in " + range.to_string());
      return value;
    }
  } // namespace

  bool Range::contains(const double value) const
  {
    return (lower_exclusive ? value > lower : value >= lower) && (upper_exclusive ? value < upper : value <= upper);
  }

  std::string Range::to_string() const
  {
    const bool open_below = lower_exclusive || !std::isfinite(lower);
    const bool open_above = upper_exclusive || !std::isfinite(upper);
    return (open_below ? "(" : "[") + text::format(lower) + ", " + text::format(upper) + (open_above ? ")" : "]");
  }

  Section::Section(ParameterTree &tree, std::vector<std::string> path)
    : tree_(&tree), path_(std::move(path))
  {
    tree_->declare_section(path_);
  }

  Section Section::sub(const std::string &name) const
  {
    auto path = path_;
    path.push_back(name);
    return Section(*tree_, path);
  }

  double Section::number(const std::string &name,
                         const Default<double> &value,
                         const Range &range,
                         const std::string &unit,
                         const std::string &sentence)
  {
    const double result =
      read(*tree_,
           path_,
           {name, text::format(value.value), value.required, unit, range.to_string(), sentence, {}},
           [range](const std::string &text) { return number_in(text, range); });
    // A default may stand for "as far as you like".
    if (result != value.value || value.required)
      check_magnitudes(name, {result}, range.lower >= 0. && range.lower_exclusive, unit);
    return result;
  }


  void Section::check_magnitudes(const std::string &name, const std::vector<double> &values, const bool are_sizes,
                                 const std::string &unit) const
  {
    if (tree_->is_documentation() || unit.empty() || unit == "1")
      return;
    try
    {
      for (const double value : values)
        tree_->magnitudes().add(value, are_sizes, unit, to_string(path_, name));
    }
    catch (const std::invalid_argument &error)
    {
      fail(name, error.what());
    }
  }

  int Section::integer(const std::string &name,
                       const int value,
                       const int smallest,
                       const int largest,
                       const std::string &sentence)
  {
    const Range range = {
      smallest == INT_MIN ? Range().lower : smallest, largest == INT_MAX ? Range().upper : largest, false, false};
    return read(*tree_,
                path_,
                {name, std::to_string(value), false, "", "integer in " + range.to_string(), sentence, {}},
                [range](const std::string &text) {
                  const double number = number_in(text, range);
                  if (number != std::floor(number) || std::abs(number) > INT_MAX)
                    throw std::invalid_argument("must be an integer in " + range.to_string());
                  return static_cast<int>(number);
                });
  }

  bool Section::flag(const std::string &name, const bool value, const std::string &sentence)
  {
    return read(*tree_,
                path_,
                {name, value ? "true" : "false", false, "", "true or false", sentence, {}},
                [](const std::string &text) {
                  if (text == "true" || text == "yes" || text == "on")
                    return true;
                  if (text == "false" || text == "no" || text == "off")
                    return false;
                  throw std::invalid_argument("must be true or false");
                });
  }

  std::string Section::text(const std::string &name, const Default<std::string> &value, const std::string &sentence)
  {
    const bool required = value.required;
    return read(*tree_,
                path_,
                {name, value.value, required, "", "", sentence, {}},
                [required](const std::string &text) {
                  if (required && text.empty())
                    throw std::invalid_argument("must not be empty");
                  return text;
                });
  }

  std::string Section::choice(const std::string &name,
                              const std::string &value,
                              const std::vector<std::string> &choices,
                              const std::string &sentence)
  {
    const std::string allowed = "one of " + text::join(choices, ", ");
    return read(*tree_,
                path_,
                {name, value, false, "", allowed, sentence, {}},
                [choices, allowed](const std::string &text) {
                  if (std::find(choices.begin(), choices.end(), text) == choices.end())
                    throw std::invalid_argument("must be " + allowed + " (nearest: " + text::nearest(text, choices) +
                                                ")");
                  return text;
                });
  }

  std::vector<std::string>
  Section::names(const std::string &name, const std::string &value, const std::string &sentence)
  {
    return read(*tree_,
                path_,
                {name, value, false, "", "names separated by commas", sentence, {}},
                [](const std::string &text) {
                  auto result = text::split(text::unquoted(text), ',');
                  for (auto i = result.begin(); i != result.end(); ++i)
                  {
                    if (i->empty())
                      throw std::invalid_argument("has a comma without a name");
                    if (std::find(result.begin(), i, *i) != i)
                      throw std::invalid_argument("names '" + *i + "' twice");
                  }
                  return result;
                });
  }

  std::vector<std::string>
  Section::section_names(const std::string &name, const std::string &value, const std::string &sentence)
  {
    auto result = names(name, value, sentence);
    for (const auto &own : result)
    {
      if (own.find('/') != std::string::npos || own == "." || own == ".." || text::printable(own) != own)
        fail(name, "'" + own + "' cannot be a name: it becomes part of columns and of file names, and must have no "
                               "'/' and no control characters");
      if (own.size() > ceilings::name_bytes / 2)
        fail(name, "a name has at most " + std::to_string(ceilings::name_bytes / 2) + " bytes");
    }
    return result;
  }

  std::vector<double> Section::numbers(const std::string &name,
                                       const std::string &value,
                                       const std::string &unit,
                                       const std::string &sentence)
  {
    auto result = read(*tree_,
                       path_,
                       {name, value, false, unit, "numbers separated by commas", sentence, {}},
                       [](const std::string &text) {
                         std::vector<double> all;
                         for (const auto &piece : text::split(text::unquoted(text), ','))
                           all.push_back(evaluate_number(piece));
                         return all;
                       });
    check_magnitudes(name, result, false, unit);
    return result;
  }

  std::vector<std::vector<double>> Section::rows(const std::string &name,
                                                 const Default<std::string> &value,
                                                 const unsigned int columns,
                                                 const std::string &unit,
                                                 const std::string &sentence)
  {
    const bool required = value.required;
    const std::string form = "rows of " + std::to_string(columns) + " numbers separated by semicolons";
    auto rows =
      read(*tree_,
           path_,
           {name, value.value, required, unit, form, sentence, {}},
           [columns, form, required](const std::string &text) {
             std::vector<std::vector<double>> result;
             auto pieces = text::split(text::unquoted(text), ';');
             if (!pieces.empty() && pieces.back().empty()) // "0 0; 1 0;"
               pieces.pop_back();
             for (const auto &piece : pieces)
             {
               const std::vector<double> row = row_in(piece);
               if (row.size() != columns)
                 throw std::invalid_argument("row '" + piece.substr(0, 80) + "' has " + std::to_string(row.size()) +
                                             " numbers; must be " + form);
               result.push_back(row);
             }
             if (required && result.empty())
               throw std::invalid_argument("must be " + form);
             return result;
           });
    for (const auto &row : rows)
      check_magnitudes(name, row, false, unit);
    return rows;
  }

  TimeFunction Section::function(const std::string &name,
                                 const Default<std::string> &value,
                                 const std::string &unit,
                                 const std::string &sentence,
                                 const std::map<std::string, double> &constants)
  {
    std::string allowed = "expression in t";
    for (const auto &[constant, constant_value] : constants)
      allowed += ", " + constant;
    allowed += ", or table 'time: value, ...'";
    auto result = read(*tree_,
                       path_,
                       {name, value.value, value.required, unit, allowed, sentence, {}},
                       [constants](const std::string &text) { return TimeFunction(text, constants); });
    if (result.is_constant())
      check_magnitudes(name, {result(0.)}, false, unit);
    return result;
  }

  bool Section::given(const std::string &name) const
  {
    return tree_->given(path_, name);
  }

  bool Section::documentation() const
  {
    return tree_->is_documentation();
  }

  void Section::fail(const std::string &name, const std::string &message) const
  {
    tree_->fail(path_, name, message);
  }

  const std::string &Section::title() const
  {
    static const std::string of_root;
    return path_.empty() ? of_root : path_.back();
  }

  std::string Section::path() const
  {
    return to_string(path_);
  }


  std::string read_choice(Section &section,
                          const std::string &entry,
                          const std::string &default_name,
                          const std::vector<std::string> &choices,
                          const std::string &sentence)
  {
    return section.choice(entry, default_name, choices, sentence);
  }
} // namespace deltaform
