#pragma once

#include <deltaform/parameters/parameter_tree.h>

#include <string>
#include <vector>

namespace deltaform
{
  /// Every entry there is, whatever is chosen, from the documentation of all parts. What has a name of its own in a
  /// scene (tools, stages) is called "<name>".
  class KnownEntries
  {
  public:
    KnownEntries();

    const std::vector<ParameterTree::Documented> &all() const
    {
      return all_;
    }

    /// Where an entry stands in a scene: its path in the documentation without the choices ("Shape: die").
    static SectionPath place(const ParameterTree::Documented &entry);

    /// The choices with which an entry exists: "Shape: die".
    static std::vector<std::string> choices(const ParameterTree::Documented &entry);

    /// Capitals do not count; what has a name of its own goes with any.
    static bool same(const std::string &part, const std::string &asked);

    /// Does a scene with the right choices have this entry or, if @p name is empty, this section?
    bool contain(const SectionPath &path, const std::string &name) const;

  private:
    std::vector<ParameterTree::Documented> all_;
  };
} // namespace deltaform
