#include <deltaform/base/scene_error.h>
#include <deltaform/base/scene_file.h>
#include <deltaform/base/text.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace deltaform
{
  namespace
  {
    /// White space inside of names counts as one blank, as in deal.II.
    std::string tidy(const std::string &name)
    {
      std::istringstream words(name);
      std::string result, word;
      while (words >> word)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }

    std::string read_whole(const std::string &file_name, const std::string &complaint_opening)
    {
      if (std::filesystem::is_directory(file_name))
        throw SceneError(complaint_opening + "cannot be read: it is a folder.");
      std::ifstream file(file_name);
      if (!file)
        throw SceneError(complaint_opening + "cannot be read: " + std::strerror(errno) + ".");
      return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }

    /// Goes through one file, and by recursion through what it includes.
    class Scanner
    {
    public:
      Scanner(SceneFile &scene, const SectionPath &path, const std::vector<std::string> &including)
        : scene_(scene), outer_depth_(path.size()), path_(path), files_(including)
      {
      }

      void scan(const std::string &content, const std::string &file_name)
      {
        files_.push_back(file_name);
        std::istringstream lines(content);
        std::string line, statement;
        for (unsigned int number = 1; std::getline(lines, line); ++number)
        {
          const std::string code = text::trim(line.substr(0, line.find('#')));
          // A comment between continued lines does not end the statement.
          if (code.empty() && !statement.empty() && line.find('#') != std::string::npos)
            continue;
          if (statement.empty())
            origin_ = {file_name, number};
          if (!code.empty() && code.back() == '\\')
          {
            statement += code.substr(0, code.size() - 1);
            continue;
          }
          interpret(text::trim(statement + code));
          statement.clear();
        }
        interpret(text::trim(statement));
        if (path_.size() > outer_depth_)
          throw SceneError(opened_.back().to_string() + ": subsection " + to_string(path_) +
                           " is never closed: an 'end' is missing.");
      }

    private:
      void interpret(const std::string &statement)
      {
        if (statement.empty())
          return;
        const auto word_end = std::min(statement.find_first_of(" \t"), statement.size());
        std::string keyword = statement.substr(0, word_end);
        for (char &c : keyword)
          c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        const std::string rest = text::trim(statement.substr(word_end));

        if (keyword == "subsection" && !rest.empty())
          begin(tidy(rest));
        else if (keyword == "end" && rest.empty())
          end();
        else if (keyword == "include" && !rest.empty())
          include(rest);
        else if (keyword == "set" && rest.find('=') != std::string::npos && rest.front() != '=')
          set(tidy(rest.substr(0, rest.find('='))), text::trim(rest.substr(rest.find('=') + 1)));
        else
          throw SceneError(origin_.to_string() + ": cannot understand '" + statement.substr(0, 80) +
                           "'. A line is 'subsection NAME', 'set ENTRY = VALUE', 'end', 'include FILE' or a comment "
                           "that starts with '#'.");
      }

      void begin(const std::string &name)
      {
        path_.push_back(name);
        opened_.push_back(origin_);
        if (scene_.find(path_) == nullptr)
          scene_.subsections.push_back({path_, origin_});
      }

      void end()
      {
        if (path_.size() == outer_depth_)
          throw SceneError(origin_.to_string() + ": this 'end' closes no subsection" +
                           (outer_depth_ > 0 ? " of this file." : "."));
        path_.pop_back();
        opened_.pop_back();
      }

      void set(const std::string &name, const std::string &value)
      {
        const auto [previous, is_new] = stated_here_.emplace(std::make_pair(path_, name), origin_.line);
        if (!is_new)
          throw SceneError(origin_.to_string() + ": " + to_string(path_, name) + " has already been set in line " +
                           std::to_string(previous->second) + " of this file. Remove one of the two.");
        for (auto &entry : scene_.entries)
          if (entry.path == path_ && entry.name == name)
          {
            entry.value = value;
            entry.origin = origin_;
            return;
          }
        scene_.entries.push_back({path_, name, value, origin_});
      }

      void include(const std::string &relative_name)
      {
        namespace fs = std::filesystem;
        const fs::path resolved = fs::path(relative_name).is_absolute()
                                    ? fs::path(relative_name)
                                    : fs::path(origin_.file).parent_path() / relative_name;
        const std::string file_name = resolved.lexically_normal().string();
        const std::string opening = origin_.to_string() + ": include " + relative_name;
        for (const auto &file : files_)
          if (fs::weakly_canonical(file) == fs::weakly_canonical(file_name))
            throw SceneError(opening + " closes a cycle: " + text::join(files_, " -> ") + " -> " + file_name + ".");
        const Origin here = origin_;
        Scanner(scene_, path_, files_).scan(read_whole(file_name, opening + ": '" + file_name + "' "), file_name);
        origin_ = here;
      }

      SceneFile &scene_;
      const std::size_t outer_depth_;
      SectionPath path_;
      std::vector<Origin> opened_;
      std::vector<std::string> files_; ///< this one and those that include it
      std::map<std::pair<SectionPath, std::string>, unsigned int> stated_here_;
      Origin origin_;
    };
  } // namespace

  std::string Origin::to_string() const
  {
    return line == 0 ? file : file + ":" + std::to_string(line);
  }

  std::string to_string(const SectionPath &path)
  {
    return text::join(path, "/");
  }

  std::string to_string(const SectionPath &path, const std::string &entry)
  {
    return path.empty() ? entry : to_string(path) + "/" + entry;
  }

  SceneFile SceneFile::read(const std::string &file_name)
  {
    return parse(read_whole(file_name, file_name + ": "), file_name);
  }

  SceneFile SceneFile::parse(const std::string &text, const std::string &name)
  {
    SceneFile scene;
    scene.name = name;
    Scanner(scene, {}, {}).scan(text, name);
    return scene;
  }

  void SceneFile::override_entry(const std::string &assignment)
  {
    const auto equals = assignment.find('=');
    auto path = text::split(assignment.substr(0, equals), '/');
    if (equals == std::string::npos || path.empty() || path.back().empty())
      throw SceneError("--set \"" + assignment + "\": expected \"Section/Entry=value\".");
    const std::string entry_name = tidy(path.back());
    const std::string value = text::trim(assignment.substr(equals + 1));
    // Otherwise the scene that is echoed into the output folder would not read back.
    if (value.find_first_of("#\n\r") != std::string::npos || (!value.empty() && value.back() == '\\'))
      throw SceneError("--set \"" + assignment + "\": a value is one line without '#' and without '\\' at its end.");
    path.pop_back();
    for (auto &section : path)
      section = tidy(section);
    for (auto &entry : entries)
      if (entry.path == path && entry.name == entry_name)
      {
        entry.value = value;
        entry.origin = {"--set", 0};
        return;
      }
    entries.push_back({path, entry_name, value, {"--set", 0}});
  }

  const SceneFile::Entry *SceneFile::find(const SectionPath &path, const std::string &entry) const
  {
    for (const auto &candidate : entries)
      if (candidate.name == entry && candidate.path == path)
        return &candidate;
    return nullptr;
  }

  const SceneFile::Subsection *SceneFile::find(const SectionPath &path) const
  {
    for (const auto &candidate : subsections)
      if (candidate.path == path)
        return &candidate;
    return nullptr;
  }
} // namespace deltaform
