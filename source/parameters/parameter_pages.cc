#include <deltaform/parameters/parameter_pages.h>
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

  void print_prm(std::ostream &out, const DeclaredSection &section, const SectionPath &path, const ValueOf &value)
  {
    const std::string indent(2 * path.size(), ' ');
    bool first = true;
    for (const auto &entry : section.entries)
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
    for (const auto &inner : section.sections)
    {
      std::ostringstream content;
      print_prm(content, *inner, below(path, inner->name), value);
      if (content.str().empty())
        continue;
      if (!first)
        out << '\n';
      first = false;
      out << indent << "subsection " << inner->name << '\n'
          << content.str() << indent << "end\n";
    }
  }

  void print_markdown(std::ostream &out, const DeclaredSection &root)
  {
    root.visit({}, [&out](const DeclaredSection &section, const SectionPath &path) {
      if (section.entries.empty() && section.sentence.empty())
        return;
      out << "## " << (path.empty() ? "Outermost level" : to_string(path)) << "\n\n";
      if (!section.sentence.empty())
        out << code(section.sentence) << "\n\n";
      if (section.entries.empty())
        return;
      out << "| entry | default | unit | allowed | meaning |\n|---|---|---|---|---|\n";
      for (const auto &entry : section.entries)
        out << "| " << cell(entry.name) << " | "
            << (entry.required ? "required, e.g. " + code(entry.value) : code(entry.value)) << " | " << cell(entry.unit)
            << " | " << cell(entry.allowed) << " | " << cell(entry.sentence) << " |\n";
      out << '\n';
    });
  }
} // namespace deltaform
