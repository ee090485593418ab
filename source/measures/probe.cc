#include <deltaform/measures/probe.h>
#include <deltaform/parameters/section.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace deltaform
{
  namespace
  {
    std::size_t column(const Table &table, const std::string &name)
    {
      return static_cast<std::size_t>(std::find(table.names.begin(), table.names.end(), name) - table.names.begin());
    }

    /// Numbers separated by blanks, if @p text is nothing else.
    std::optional<std::vector<double>> numbers_of(const std::string &text)
    {
      std::istringstream stream(text);
      std::vector<double> result;
      for (double value = 0.; stream >> value;)
        result.push_back(value);
      return stream.eof() && !result.empty() ? std::make_optional(result) : std::nullopt;
    }

    /// Initial place of a row.
    Point2 place_of(const Table &profile, const std::vector<double> &row)
    {
      return {row[column(profile, "r")] - row[column(profile, "u_r")],
              row[column(profile, "z")] - row[column(profile, "u_z")]};
    }
  } // namespace


  Probe::Probe(const std::string &name, Section section, const Blank &blank)
    : name_(name)
  {
    const std::string place =
      section.text("Place", required(std::string("start")),
                   "Where on the undeformed blank: start, end, an arc length from the start, or a point 'r z', which "
                   "stands for the nearest row of profile_*.csv.");
    const auto wanted = section.names("Fields", "u_r, u_z, eps_thickness",
                                      "Columns of profile_*.csv; each becomes a column of history.csv.");
    const Table profile = blank.fields().profile(Vector(blank.n_dofs()));
    read_place(section, place, profile);
    for (const auto &field : wanted)
    {
      const std::size_t i = column(profile, field);
      if (i == profile.names.size())
        section.fail("Fields", "the profile of this blank has no column '" + field + "', only " +
                                 text::join(profile.names, ", "));
      fields_.push_back({field, profile.units[i]});
    }
    if (wanted.empty())
      section.fail("Fields", "name at least one field");
  }


  void Probe::read_place(Section &section, const std::string &place, const Table &profile)
  {
    const std::size_t s = column(profile, "S0");
    const double end = profile.rows.back()[s], begin = profile.rows.front()[s];
    const auto numbers = numbers_of(place);
    if (place == "start" || place == "end")
      arc_length_ = place == "start" ? begin : end;
    else if (numbers && numbers->size() == 1)
      arc_length_ = numbers->front();
    else if (numbers && numbers->size() == 2)
      point_ = Point2((*numbers)[0], (*numbers)[1]);
    else
      section.fail("Place", "'" + place + "' is neither start, end, an arc length nor a point 'r z'");
    if (arc_length_ && !(*arc_length_ >= begin && *arc_length_ <= end))
      section.fail("Place", "the blank goes from arc length " + text::rounded(begin) + " to " + text::rounded(end));
  }


  std::vector<double> Probe::values(const Table &profile) const
  {
    const auto &rows = profile.rows;
    std::size_t a = 0, b = 0;
    double share = 0.;
    if (arc_length_)
    {
      const std::size_t s = column(profile, "S0");
      while (b + 1 < rows.size() && rows[b][s] < *arc_length_)
        ++b;
      a = b > 0 ? b - 1 : 0;
      share = b > a && rows[b][s] > rows[a][s] ? (*arc_length_ - rows[a][s]) / (rows[b][s] - rows[a][s]) : 0.;
    }
    else
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < rows.size(); ++i)
        if (const double distance = (place_of(profile, rows[i]) - point_).norm(); distance < nearest)
        {
          nearest = distance;
          a = b = i;
        }
    }
    std::vector<double> result;
    for (const auto &field : fields_)
    {
      const std::size_t i = column(profile, field.name);
      result.push_back((1. - share) * rows[a][i] + share * rows[b][i]);
    }
    return result;
  }
} // namespace deltaform
