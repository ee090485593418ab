#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/reports/quantities.h>
#include <deltaform/reports/reported_columns.h>
#include <deltaform/tools/tool_gap.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    using Increment = AcceptedIncrement;
    using Row = Columns::Row;

    void describe_blank(const Blank &blank, Columns &columns)
    {
      const double thickness = blank.initial_thickness();
      columns.add({{"thinning", "1", "1 - smallest thickness over the initial one"}},
                  [thickness](const Increment &increment, Row &row) {
                    row.emplace_back(1. - increment.smallest_thickness() / thickness);
                  });
      columns.add({{"plastic_strain", "1", "largest equivalent plastic strain of the profile"}},
                  [](const Increment &increment, Row &row) {
                    const Table &profile = increment.profile();
                    const auto name =
                      std::find(profile.names.begin(), profile.names.end(), "equivalent_plastic_strain");
                    double largest = 0.;
                    for (const auto &values : profile.rows)
                      if (name != profile.names.end())
                        largest = std::max(largest, values[static_cast<std::size_t>(name - profile.names.begin())]);
                    row.emplace_back(largest);
                  });
    }

    void describe_touching(const Actors &actors, Columns &columns)
    {
      for (const auto &interface : actors.interfaces)
        columns.add({{text::column_name(interface->tool().name()) + "_touching", "1",
                      "contact points that touch the tool"}},
                    [contact = interface.get()](const Increment &, Row &row) {
                      const auto &points = contact->committed();
                      row.emplace_back(static_cast<double>(
                        std::count_if(points.begin(), points.end(),
                                      [](const ContactPointState &point) { return point.touching; })));
                    });
    }

    void describe_gaps(const Actors &actors, Columns &columns)
    {
      const auto &tools = actors.tools;
      for (unsigned int i = 0; i < tools.size(); ++i)
        for (unsigned int k = 0; k < tools.size(); ++k)
          if (i != k)
            columns.add({{text::column_name(tools[i]->name()) + "_to_" + text::column_name(tools[k]->name()) + "_gap",
                          "length",
                          "between the outlines of two tools"}},
                        [&tools, i, k](const Increment &increment, Row &row) {
                          double reach = 0.;
                          for (const auto &x : increment.model.blank().positions(increment.model.committed()))
                            reach = std::max(reach, 1.5 * x.norm());
                          row.push_back(Columns::if_known(tool_gap(*tools[i], increment.model.travel(i), *tools[k],
                                                                   increment.model.travel(k), reach)));
                        });
    }
  } // namespace


  Columns quantities(const Actors &actors)
  {
    const ReportedNames names = reported_names(actors);
    Columns columns;
    describe_tools(names.tools, columns);
    describe_thickness(columns);
    describe_supports(names.supports, columns);
    describe_load_sizes(names.other_loads, columns);
    describe_pressures(names.pressures, columns);
    describe_beads(names.beads, columns);
    describe_probes(names.probes, columns);
    describe_blank(*actors.blank, columns);
    describe_touching(actors, columns);
    describe_gaps(actors, columns);
    return columns;
  }
} // namespace deltaform
