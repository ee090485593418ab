#pragma once

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

/// The message of the exception of type Error that @p action must throw.
template <typename Error, typename Action>
std::string
message_of(const Action &action)
{
  try
  {
    action();
  }
  catch (const Error &error)
  {
    return error.what();
  }
  BOOST_ERROR("nothing was thrown");
  return {};
}

/// Does @p message contain all of @p parts?
inline void
check_contains(const std::string &message, const std::initializer_list<const char *> &parts)
{
  for (const char *const part : parts)
    BOOST_CHECK_MESSAGE(message.find(part) != std::string::npos, "'" << part << "' is not in: " << message);
}

inline std::string
content_of(const std::string &path)
{
  std::ifstream file(path);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

/// A folder for the files of one test, removed at its end.
struct TemporaryFolder
{
  TemporaryFolder()
    : path(std::filesystem::temp_directory_path() / ("deltaform_test_" + std::to_string(getpid()) + "_" +
                                                     boost::unit_test::framework::current_test_case().p_name.get()))
  {
    std::filesystem::create_directories(path);
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }

  /// The name of the file @p name in the folder, with @p content if there is any.
  std::string file(const std::string &name, const std::string &content = "") const
  {
    const auto file_path = path / name;
    std::filesystem::create_directories(file_path.parent_path());
    if (!content.empty())
      std::ofstream(file_path) << content;
    return file_path.string();
  }

  std::filesystem::path path;
};
