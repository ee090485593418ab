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
    void add(const std::string &name, double value);
    void add(const std::string &name, int value);
    void add(const std::string &name, unsigned int value);
    void add(const std::string &name, bool value);
    void add(const std::string &name, const char *value); ///< else a literal would become a bool
    void add(const std::string &name, const std::string &value);
    void add(const std::string &name, const JsonObject &value);
    void add(const std::string &name, const std::vector<double> &values);
    void add(const std::string &name, const std::vector<std::string> &values);
    void add(const std::string &name, const std::vector<JsonObject> &values);

    /// The object as text, its members on lines of their own, indented by two more than @p indent.
    std::string to_string(unsigned int indent = 0) const;

  private:
    std::vector<std::pair<std::string, std::string>> members_; ///< name and value as text
  };

  /// Write @p object as the file @p path, whole or not at all. @throws SceneError
  void write_json(const std::string &path, const JsonObject &object);
} // namespace deltaform
