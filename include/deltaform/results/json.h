#pragma once

#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /// An object of a JSON file, member by member in their order. Numbers that are not finite become null.
  class JsonObject
  {
  public:
    void
    add(const std::string &name, double value);
    void
    add(const std::string &name, const std::string &value);
    void
    add(const std::string &name, const JsonObject &value);
    void
    add(const std::string &name, const std::vector<double> &values);

    std::string
    to_string(unsigned int indent = 0) const;

  private:
    std::vector<std::pair<std::string, std::string>> members_; ///< name and value as text
    std::vector<std::pair<std::string, JsonObject>>  objects_;
    std::vector<bool>                                is_object_;
  };
} // namespace deltaform
