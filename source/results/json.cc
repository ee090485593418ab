#include <deltaform/base/atomic_file.h>
#include <deltaform/base/text.h>
#include <deltaform/results/json.h>

#include <cmath>
#include <ostream>

namespace deltaform
{
  namespace
  {
    std::string json(const double value)
    {
      return std::isfinite(value) ? text::format(value) : "null";
    }

    std::string json(const std::string &value)
    {
      return text::json_quote(value);
    }

    std::string json(const JsonObject &value)
    {
      return value.to_string();
    }

    template <typename T>
    std::string json(const std::vector<T> &values)
    {
      std::vector<std::string> pieces;
      for (const auto &value : values)
        pieces.push_back(json(value));
      return "[" + text::join(pieces, ", ") + "]";
    }
  } // namespace

  void JsonObject::add(const std::string &name, const double value)
  {
    members_.emplace_back(name, json(value));
  }

  void JsonObject::add(const std::string &name, const int value)
  {
    members_.emplace_back(name, std::to_string(value));
  }

  void JsonObject::add(const std::string &name, const unsigned int value)
  {
    members_.emplace_back(name, std::to_string(value));
  }

  void JsonObject::add(const std::string &name, const bool value)
  {
    members_.emplace_back(name, value ? "true" : "false");
  }

  void JsonObject::add(const std::string &name, const char *const value)
  {
    members_.emplace_back(name, text::json_quote(value));
  }

  void JsonObject::add(const std::string &name, const std::string &value)
  {
    members_.emplace_back(name, json(value));
  }

  void JsonObject::add(const std::string &name, const JsonObject &value)
  {
    members_.emplace_back(name, json(value));
  }

  void JsonObject::add(const std::string &name, const std::vector<double> &values)
  {
    members_.emplace_back(name, json(values));
  }

  void JsonObject::add(const std::string &name, const std::vector<std::string> &values)
  {
    members_.emplace_back(name, json(values));
  }

  void JsonObject::add(const std::string &name, const std::vector<JsonObject> &values)
  {
    members_.emplace_back(name, json(values));
  }

  std::string JsonObject::to_string(const unsigned int indent) const
  {
    if (members_.empty())
      return "{}";
    const std::string space(indent + 2, ' ');
    std::string result;
    for (const auto &[name, value] : members_)
    {
      result += (result.empty() ? "{\n" : ",\n") + space + text::json_quote(name) + ": ";
      // A line break within a string is escaped: every other one belongs to a nested object and moves in with it.
      for (const char c : value)
        result += c == '\n' ? '\n' + space : std::string(1, c);
    }
    return result + "\n" + std::string(indent, ' ') + "}";
  }

  void write_json(const std::string &path, const JsonObject &object)
  {
    write_file_atomically(path, [&object](std::ostream &out) { out << object.to_string() << '\n'; });
  }
} // namespace deltaform
