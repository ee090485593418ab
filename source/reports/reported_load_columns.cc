// What loads and probes have to report.
#include <deltaform/loads/load_way.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/reports/reported_columns.h>

#include <cmath>

namespace deltaform
{
  namespace
  {
    using Increment = AcceptedIncrement;
    using Row = Columns::Row;

    const Load *find(const Model &model, const std::string &name)
    {
      for (const auto &load : model.actors().loads)
        if (load->name() == name)
          return load.get();
      return nullptr;
    }

    double size_of(const Increment &increment, const std::string &name)
    {
      const Load &load = *find(increment.model, name);
      return load.acts_in(increment.stage.name) ? load.size(increment.model.committed(), increment.time) : 0.;
    }

    /// Of the nodes of a face since the start, along z.
    double largest_rise(const Model &model, const std::string &face)
    {
      const auto now = model.blank().positions(model.committed());
      const auto before = model.blank().positions(Vector(model.committed().size()));
      double result = 0.;
      for (const auto node : model.blank().boundary().face_nodes(face))
        if (const double rise = now[node][1] - before[node][1]; std::abs(rise) > std::abs(result))
          result = rise;
      return result;
    }
  } // namespace


  void describe_load_sizes(const std::vector<std::string> &names, Columns &columns)
  {
    for (const auto &name : names)
      columns.add({{text::column_name(name) + "_size", "load",
                    "line load or body force: `Value`, or what follows from `Control`; 0 in stages without the load"}},
                  [name](const Increment &increment, Row &row) { row.emplace_back(size_of(increment, name)); });
  }


  void describe_pressures(const std::vector<std::string> &names, Columns &columns)
  {
    for (const auto &name : names)
      columns.add({{text::column_name(name) + "_pressure", "stress",
                    "`Value`, or what follows from `Control`; 0 in stages without the load"},
                   {text::column_name(name) + "_volume", "volume",
                    "that the pressed face has swept since the start, positive if the pressure does work (plane "
                    "strain: area)"},
                   {text::column_name(name) + "_height", "length",
                    "largest displacement along z of a node of the pressed face: the height of a dome"}},
                  [name](const Increment &increment, Row &row) {
                    const Load &load = *find(increment.model, name);
                    row.insert(row.end(), {size_of(increment, name), LoadWay(load, increment.model.committed()).value(),
                                           largest_rise(increment.model, load.pressed_face())});
                  });
  }


  void describe_beads(const std::vector<std::string> &names, Columns &columns)
  {
    for (const auto &name : names)
      columns.add({{text::column_name(name) + "_restraint", "force/length",
                    "force of a draw bead on the sheet per length of the bead, positive against a sheet that is drawn "
                    "towards its start"},
                   {text::column_name(name) + "_path", "length",
                    "of undeformed sheet that has passed the draw bead, to and fro"},
                   {text::column_name(name) + "_work", "force*length",
                    "of the sheet against the draw bead; `load_work` holds it with the other sign"}},
                  [name](const Increment &increment, Row &row) {
                    const auto restraint = find(increment.model, name)->restraint().value();
                    row.insert(row.end(), {restraint.force, restraint.path, restraint.work});
                  });
  }


  void describe_probes(const std::vector<Probe> &probes, Columns &columns)
  {
    for (const Probe &probe : probes)
    {
      std::vector<Columns::Column> own;
      for (const auto &field : probe.fields())
        own.push_back({text::column_name(probe.name()) + "_" + field.name, field.unit,
                       "of the profile, at a probe (`Output/Probes`)"});
      columns.add(own, [probe](const Increment &increment, Row &row) {
        for (const double value : probe.values(increment.profile()))
          row.emplace_back(value);
      });
    }
  }
} // namespace deltaform
