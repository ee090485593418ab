#include <deltaform/results/earlier_run.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <regex>
#include <vector>

namespace deltaform
{
  namespace
  {
    namespace fs = std::filesystem;

    /// Is it a table of this program? Its second line says so.
    bool is_table(const fs::path &path)
    {
      std::ifstream file(path);
      std::string line;
      for (unsigned int i = 0; i < 2 && std::getline(file, line); ++i)
        if (line.rfind("# deltaform ", 0) == 0)
          return true;
      return false;
    }
  } // namespace


  unsigned int remove_earlier_results(const std::string &folder)
  {
    const std::regex table("(profile|contact|tools)_.+\\.csv");
    std::error_code error;
    std::vector<fs::path> found;
    for (const auto &entry : fs::directory_iterator(folder, error))
      if (entry.is_regular_file(error) && std::regex_match(entry.path().filename().string(), table) &&
          is_table(entry.path()))
        found.push_back(entry.path());

    const fs::path series = fs::path(folder) / "scene.pvd";
    if (std::ifstream file(series); file)
    {
      // Names only: nothing outside the folder can be meant.
      const std::regex picture("file=\"((blank|tools)_[0-9_]+\\.vtu)\"");
      std::string line;
      for (std::smatch match; std::getline(file, line);)
        if (std::regex_search(line, match, picture))
          found.push_back(fs::path(folder) / match[1].str());
      found.push_back(series);
    }
    unsigned int count = 0;
    for (const auto &path : found)
      count += fs::remove(path, error);
    return count;
  }


  unsigned int remove_drafts(const std::string &folder)
  {
    const std::regex draft("(scene\\.(prm|pvd)|(summary|timing)\\.json|checkpoint\\.bin|(history|profile_.+|contact_.+|"
                           "tools_.+)\\.csv|(blank|tools)_[0-9_]+\\.vtu)\\.part");
    std::error_code error;
    std::vector<fs::path> found;
    for (const auto &entry : fs::directory_iterator(folder, error))
      if (entry.is_regular_file(error) && std::regex_match(entry.path().filename().string(), draft))
        found.push_back(entry.path());
    unsigned int count = 0;
    for (const auto &path : found)
      count += fs::remove(path, error);
    return count;
  }


  std::optional<int> earlier_exit_status(const std::string &folder)
  {
    std::ifstream file(fs::path(folder) / "summary.json");
    const auto summary = nlohmann::json::parse(file, nullptr, /* allow_exceptions = */ false);
    if (!summary.is_object() || !summary.contains("exit_status") || !summary["exit_status"].is_number_integer())
      return std::nullopt;
    return summary["exit_status"].get<int>();
  }
} // namespace deltaform
