// A ParameterTree as a scene and as a page of documentation.
#include <deltaform/parameters/parameter_tree.h>
#include <deltaform/parameters/text.h>

#include <ostream>
#include <sstream>

namespace deltaform
{
  namespace
  {
    constexpr std::size_t line_length = 110;

    /// Break @p words into comment lines.
    void print_comment(std::ostream &out, const std::string &indent, const std::string &words)
    {
      std::istringstream stream(words);
      std::string word, line = indent + "#";
      while (stream >> word)
      {
        if (line.size() + 1 + word.size() > line_length && line.size() > indent.size() + 1)
        {
          out << line << '\n';
          line = indent + "#";
        }
        line += " " + word;
      }
      out << line << '\n';
    }

    /// A cell of a table in Markdown.
    std::string cell(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        (result += (c == '|' ? "\\" : "")) += c;
      return result;
    }

    std::string code(const std::string &text)
    {
      return text.empty() ? "" : "`" + cell(text) + "`";
    }
  } // namespace

  void ParameterTree::print_prm(std::ostream &out) const
  {
    print_prm(out, root_, {});
  }

  void ParameterTree::print_prm(std::ostream &out, const Node &node, const SectionPath &path) const
  {
    const std::string indent(2 * path.size(), ' ');
    bool first = true;
    for (const auto &entry : node.entries)
    {
      std::string comment = entry.unit.empty() ? "" : "[" + entry.unit + "] ";
      if (!entry.allowed.empty())
        comment += entry.allowed + (entry.required ? ", required. " : ". ");
      else if (entry.required)
        comment += "Required. ";
      comment += entry.sentence;
      if (!first)
        out << '\n';
      first = false;
      print_comment(out, indent, comment);
      const std::string text = value(path, entry);
      out << indent << "set " << entry.name << " =" << (text.empty() ? "" : " ") << text << '\n';
    }
    for (const auto &section : node.sections)
    {
      SectionPath inner = path;
      inner.push_back(section->name);
      std::ostringstream content;
      print_prm(content, *section, inner);
      if (content.str().empty())
        continue;
      if (!first)
        out << '\n';
      first = false;
      out << indent << "subsection " << section->name << '\n'
          << content.str() << indent << "end\n";
    }
  }

  std::vector<ParameterTree::Value> ParameterTree::values() const
  {
    std::vector<Value> result;
    collect_values(root_, {}, result);
    return result;
  }

  void ParameterTree::collect_values(const Node &node, const SectionPath &path, std::vector<Value> &result) const
  {
    for (const auto &entry : node.entries)
      result.push_back({path, entry.name, value(path, entry)});
    for (const auto &section : node.sections)
    {
      SectionPath inner = path;
      inner.push_back(section->name);
      collect_values(*section, inner, result);
    }
  }

  std::vector<ParameterTree::Documented> ParameterTree::documented() const
  {
    std::vector<Documented> result;
    collect_documented(root_, {}, result);
    return result;
  }

  void ParameterTree::collect_documented(const Node &node, const SectionPath &path, std::vector<Documented> &result)
  {
    for (const auto &entry : node.entries)
      result.push_back({path, entry});
    for (const auto &section : node.sections)
    {
      SectionPath inner = path;
      inner.push_back(section->name);
      collect_documented(*section, inner, result);
    }
  }

  void ParameterTree::print_markdown(std::ostream &out) const
  {
    print_markdown(out, root_, {});
  }

  void ParameterTree::print_markdown(std::ostream &out, const Node &node, const SectionPath &path) const
  {
    if (!node.entries.empty())
    {
      out << "## " << (path.empty() ? "Outermost level" : to_string(path)) << "\n\n"
          << "| entry | default | unit | allowed | meaning |\n|---|---|---|---|---|\n";
      for (const auto &entry : node.entries)
        out << "| " << cell(entry.name) << " | "
            << (entry.required ? "required, e.g. " + code(entry.value) : code(entry.value)) << " | " << cell(entry.unit)
            << " | " << cell(entry.allowed) << " | " << cell(entry.sentence) << " |\n";
      out << '\n';
    }
    for (const auto &section : node.sections)
    {
      SectionPath inner = path;
      inner.push_back(section->name);
      print_markdown(out, *section, inner);
    }
  }
} // namespace deltaform
