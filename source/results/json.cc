#include <deltaform/base/text.h>
#include <deltaform/results/json.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    std::string
    number(const double value)
    {
      return std::isfinite(value) ? text::format(value) : "null";
    }
  } // namespace



  void
  JsonObject::add(const std::string &name, const double value)
  {
    members_.emplace_back(name, number(value));
    is_object_.push_back(false);
  }



  void
  JsonObject::add(const std::string &name, const std::string &value)
  {
    members_.emplace_back(name, text::json_quote(value));
    is_object_.push_back(false);
  }



  void
  JsonObject::add(const std::string &name, const JsonObject &value)
  {
    objects_.emplace_back(name, value);
    is_object_.push_back(true);
  }



  void
  JsonObject::add(const std::string &name, const std::vector<double> &values)
  {
    std::string list;
    for (const double value : values)
      list += (list.empty() ? "" : ", ") + number(value);
    members_.emplace_back(name, "[" + list + "]");
    is_object_.push_back(false);
  }



  std::string
  JsonObject::to_string(const unsigned int indent) const
  {
    const std::string space(indent + 2, ' ');
    std::string       result = "{\n";
    unsigned int      member = 0, object = 0;
    for (unsigned int i = 0; i < is_object_.size(); ++i)
      {
        const bool is_object = is_object_[i];
        result += space + text::json_quote(is_object ? objects_[object].first : members_[member].first) + ": ";
        result += is_object ? objects_[object++].second.to_string(indent + 2) : members_[member++].second;
        result += i + 1 < is_object_.size() ? ",\n" : "\n";
      }
    return result + std::string(indent, ' ') + "}";
  }
} // namespace deltaform
