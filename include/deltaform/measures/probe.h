#pragma once

#include <deltaform/blanks/blank.h>
#include <deltaform/io/table.h>

#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /// A place of the blank that moves with it, and the columns of its profile that are watched there over time.
  class Probe
  {
  public:
    struct Field
    {
      std::string name, unit;
    };

    /// @throws SceneError if the blank has no such place or field
    Probe(const std::string &name, Section section, const Blank &blank);

    const std::string &name() const
    {
      return name_;
    }

    const std::vector<Field> &fields() const
    {
      return fields_;
    }

    /// Value of every field in the present @p profile of the blank.
    std::vector<double> values(const Table &profile) const;

  private:
    void read_place(Section &section, const std::string &place, const Table &profile);

    std::string name_;
    std::vector<Field> fields_;
    std::optional<double> arc_length_; ///< initial, from the start of the blank: between two rows of the profile
    Point2 point_; ///< else: the row nearest to this point of the undeformed blank
  };
} // namespace deltaform
