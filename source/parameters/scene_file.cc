#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/parameters/scene_file.h>
#include <deltaform/parameters/text.h>

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

    /// UTF-8 without its mark. @throws SceneError if it is another kind of text, or none
    std::string utf_8(std::string content, const std::string &complaint_opening)
    {
      const auto begins = [&content](const char *const mark) { return content.rfind(mark, 0) == 0; };
      const std::string advice = ": save it as UTF-8 (or ASCII).";
      if (begins("\xff\xfe") || begins("\xfe\xff"))
        throw SceneError(complaint_opening + "cannot be read: it is UTF-16" + advice);
      if (content.find('\0') != std::string::npos)
        throw SceneError(complaint_opening + "cannot be read: it contains zero bytes, and so is no text, or text in " +
                         "UTF-16" + advice);
      if (begins("\xef\xbb\xbf"))
        content.erase(0, 3);
      return content;
    }

    /**
     * The text of a file.
     * @param most    bytes that it may have
     * @param regular must it be a file on disk? What is read from a pipe may never come, or never end
     */
    std::string read_whole(const std::string &file_name, const std::string &complaint_opening, const std::size_t most,
                           const bool regular)
    {
      std::error_code error;
      const auto status = std::filesystem::status(file_name, error);
      if (std::filesystem::is_directory(status))
        throw SceneError(complaint_opening + "cannot be read: it is a folder.");
      if (regular && std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw SceneError(complaint_opening + "cannot be read: it is a pipe or a device, not a file.");
      std::ifstream file(file_name, std::ios::binary);
      if (!file)
        throw SceneError(complaint_opening + "cannot be read: " + std::strerror(errno) + ".");
      std::string content;
      std::vector<char> block(1u << 16);
      while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0)
      {
        content.append(block.data(), static_cast<std::size_t>(file.gcount()));
        if (content.size() > most)
          throw SceneError(complaint_opening + "is too long: a scene with all that it includes has at most " +
                           std::to_string(ceilings::scene_bytes >> 20) + " MB.");
      }
      return utf_8(std::move(content), complaint_opening);
    }

    /// What has been read for a scene so far.
    struct Consumption
    {
      std::size_t n_files = 0, n_bytes = 0;
    };

    /// Goes through one file, and by recursion through what it includes.
    class Scanner
    {
    public:
      Scanner(SceneFile &scene, Consumption &consumption, const SectionPath &path,
              const std::vector<std::string> &including)
        : scene_(scene), consumption_(consumption), outer_depth_(path.size()), path_(path), files_(including)
      {
      }

      void scan(const std::string &content, const std::string &file_name)
      {
        files_.push_back(file_name);
        consumption_.n_bytes += content.size();
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

      void check_name(const std::string &name) const
      {
        if (name.size() > ceilings::name_bytes)
          throw SceneError(origin_.to_string() + ": the name '" + name.substr(0, 40) + "...' has " +
                           std::to_string(name.size()) + " bytes; " + std::to_string(ceilings::name_bytes) +
                           " are allowed.");
        if (scene_.entries.size() + scene_.subsections.size() >= ceilings::entries)
          throw SceneError(origin_.to_string() + ": this is too much: a scene has at most " +
                           std::to_string(ceilings::entries) + " entries and subsections.");
      }

      void begin(const std::string &name)
      {
        check_name(name);
        if (path_.size() == ceilings::nesting)
          throw SceneError(origin_.to_string() + ": subsections are nested more than " +
                           std::to_string(ceilings::nesting) + " deep.");
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
        check_name(name);
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
        // A file that cannot be found has no other name; why not is said where it is read.
        const auto canonical = [](const std::string &file) {
          std::error_code error;
          const fs::path result = fs::weakly_canonical(file, error);
          return error ? fs::path(file) : result;
        };
        for (const auto &file : files_)
          if (canonical(file) == canonical(file_name))
            throw SceneError(opening + " closes a cycle: " + text::join(files_, " -> ") + " -> " + file_name + ".");
        if (files_.size() > ceilings::include_depth)
          throw SceneError(opening + ": files include one another more than " +
                           std::to_string(ceilings::include_depth) + " deep.");
        if (++consumption_.n_files > ceilings::includes)
          throw SceneError(opening + ": a scene includes at most " + std::to_string(ceilings::includes) + " files.");
        const Origin here = origin_;
        const std::size_t left = ceilings::scene_bytes - std::min(consumption_.n_bytes, ceilings::scene_bytes);
        const std::string content = read_whole(file_name, opening + ": '" + file_name + "' ", left, true);
        Scanner(scene_, consumption_, path_, files_).scan(content, file_name);
        origin_ = here;
      }

      SceneFile &scene_;
      Consumption &consumption_;
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
    return parse(read_whole(file_name, file_name + ": ", ceilings::scene_bytes, false), file_name);
  }

  SceneFile SceneFile::parse(const std::string &text, const std::string &name)
  {
    SceneFile scene;
    scene.name = name;
    Consumption consumption;
    Scanner(scene, consumption, {}, {}).scan(text, name);
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
    ++n_overrides;
    for (auto &entry : entries)
      if (entry.path == path && entry.name == entry_name)
      {
        if (entry.value != value) // what is said twice is no change
          entry.layer = n_overrides;
        entry.value = value;
        entry.origin = {"--set", 0};
        return;
      }
    entries.push_back({path, entry_name, value, {"--set", 0}, n_overrides});
  }

  void SceneFile::supply(Entry entry)
  {
    entry.layer = -1;
    if (find(entry.path, entry.name) == nullptr)
      entries.push_back(std::move(entry));
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
