#include <deltaform/io/atomic_file.h>
#include <deltaform/io/byte_stream.h>
#include <deltaform/parameters/scene_error.h>
#include <deltaform/reports/checkpoint.h>
#include <deltaform/reports/damaged_state.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <zlib.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace boost::serialization
{
  template <class Archive>
  void serialize(Archive &archive, deltaform::Checkpoint::Entry &entry, unsigned int)
  {
    archive &entry.name &entry.value;
  }

  template <class Archive>
  void serialize(Archive &archive, deltaform::Checkpoint &saved, unsigned int)
  {
    archive &saved.scene &saved.increment &saved.time &saved.stage &saved.state &saved.observers;
  }
} // namespace boost::serialization

namespace deltaform
{
  namespace
  {
    /// How the first line begins. The layout counts what changes in the bytes between two releases.
    constexpr const char *writer = "deltaform " DELTAFORM_VERSION " checkpoint, layout 8, ";

    /// The first line of the file: who wrote it, and how to tell whether it is whole.
    std::string head(const std::string &content)
    {
      const auto sum = crc32_z(0, reinterpret_cast<const Bytef *>(content.data()), content.size());
      return std::string(writer) + std::to_string(content.size()) + " bytes, CRC-32 " + std::to_string(sum);
    }

    /// "1e-3" and "0.001" are the same number.
    bool same(const std::string &a, const std::string &b)
    {
      if (a == b)
        return true;
      char *end_a = nullptr, *end_b = nullptr;
      const double x = std::strtod(a.c_str(), &end_a), y = std::strtod(b.c_str(), &end_b);
      return !a.empty() && !b.empty() && *end_a == '\0' && *end_b == '\0' && x == y;
    }

    /// An entry, its old value and its new one, if any.
    std::string change(const std::string &entry, const std::string &was, const char *const verb, const std::string &now)
    {
      return entry + " was " + was + ", is " + verb + now;
    }

    std::string must_stay(const std::string &was)
    {
      return "was " + was +
             " when the run was saved, so that it cannot be resumed. Entries of Solver, Steps, Contact (not "
             "Enforcement), Output and allowed penetrations of tools may change; with any other change, start again "
             "without --resume";
    }

    std::string is_missing(const std::string &entry, const std::string &was)
    {
      return "Cannot resume: the run was saved with " + entry + " = " + was +
             ", which the scene does not have any more. Start again without --resume.";
    }

    bool may_change(const SectionPath &path, const std::string &name)
    {
      if (path.empty())
        return name == "Title";
      const std::string &outermost = path.front();
      if (outermost == "Contact")
        return name != "Enforcement"; // whose unknowns are part of the state
      return outermost == "Solver" || outermost == "Steps" || outermost == "Output" ||
             (outermost == "Tools" && name == "Allowed penetration");
    }
  } // namespace


  std::string Checkpoint::path(const std::string &folder)
  {
    return folder + "/checkpoint.bin";
  }


  std::string Checkpoint::value(const std::string &entry) const
  {
    for (const auto &[name, text] : scene)
      if (name == entry)
        return text;
    return "";
  }


  std::string Checkpoint::damaged(const std::string &folder)
  {
    return "Cannot resume: '" + path(folder) + "' is damaged. Start again without --resume.";
  }


  void Checkpoint::write(const std::string &folder) const
  {
    ByteStream content;
    boost::archive::binary_oarchive(content.stream()) << *this;
    const std::string bytes = content.take();
    write_file_atomically(path(folder), [&](std::ostream &out) { out << head(bytes) << '\n'
                                                                     << bytes; });
  }


  std::optional<Checkpoint> Checkpoint::read(const std::string &folder)
  {
    const std::string name = path(folder);
    std::error_code code;
    if (const auto type = std::filesystem::status(name, code).type(); type == std::filesystem::file_type::not_found)
      return std::nullopt;
    const bool is_file = std::filesystem::is_regular_file(name, code);
    std::ifstream file(is_file ? name : "", std::ios::binary);
    if (!file)
      throw SceneError("Cannot resume: '" + name + "' cannot be read: " +
                       (is_file ? std::strerror(errno) : "it is no file") + ".");
    std::string first;
    std::getline(file, first);
    std::ostringstream rest;
    rest << file.rdbuf();
    const std::string bytes = rest.str();
    if (first.rfind("deltaform ", 0) == 0 && first.find(" checkpoint") != std::string::npos &&
        first.rfind(writer, 0) != 0)
    {
      const std::string other = first.substr(0, first.find(" checkpoint")), own = "deltaform " DELTAFORM_VERSION;
      throw SceneError("Cannot resume: '" + name + "' was written by another version (" +
                       (other == own ? "an earlier " : "") + other +
                       ", this is " DELTAFORM_VERSION "). Start again without --resume.");
    }
    if (first != head(bytes))
      throw SceneError(damaged(folder));
    Checkpoint result;
    try
    {
      std::istringstream content(bytes);
      boost::archive::binary_iarchive(content) >> result;
    }
    catch (const std::exception &error) // of the archive, or of a length that no memory holds
    {
      throw SceneError(damaged_state(folder, error));
    }
    return result;
  }


  std::vector<std::string> Checkpoint::changes(const ParameterTree &tree) const
  {
    std::map<std::string, std::string> before;
    for (const auto &entry : scene)
      before[entry.name] = entry.value;
    std::vector<std::string> result;
    for (const auto &[path, name, text] : tree.values())
    {
      const std::string full = to_string(path, name);
      const auto old = before.find(full);
      const std::string was = old == before.end() ? "not there" : (old->second.empty() ? "empty" : old->second);
      const bool equal = old != before.end() && same(old->second, text);
      if (old != before.end())
        before.erase(old);
      if (equal)
        continue;
      if (!may_change(path, name))
        tree.fail(path, name, must_stay(was));
      result.push_back(change(full, was, "now ", text.empty() ? "empty" : text));
    }
    for (const auto &[name, value] : before)
    {
      const auto last = name.rfind('/');
      const SectionPath path{name.substr(0, name.find('/'))};
      if (!may_change(last == std::string::npos ? SectionPath() : path, name.substr(last + 1)))
        throw SceneError(is_missing(name, value));
      result.push_back(change(name, value, "gone", ""));
    }
    return result;
  }


  std::vector<Checkpoint::Entry> Checkpoint::entries(const ParameterTree &tree)
  {
    std::vector<Entry> result;
    for (const auto &[path, name, text] : tree.values())
      result.push_back({to_string(path, name), text});
    return result;
  }
} // namespace deltaform
