// What stands in the pictures.
#include "recorder_files.h"

#include <deltaform/contact/contact_measures.h>
#include <deltaform/results/vtu.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace deltaform
{
  namespace
  {
    std::vector<DrawnField> contact_fields(const FormingProblem &problem, const std::size_t n_nodes)
    {
      const std::vector<double> none(n_nodes, 0.);
      std::vector<DrawnField> fields{{"penalty_factor", "force/length", true, 1, none},
                                     {"penetration_over_delta", "1", true, 1, none},
                                     {"contact_pressure", "stress", true, 1, none},
                                     {"contact_status", "0 free 1 slip 2 stick", true, 1, none}};
      for (const auto *pair : problem.active_pairs())
      {
        const auto pressure = contact_pressure(*pair, problem.committed());
        for (unsigned int i = 0; i < pair->n_nodes(); ++i)
        {
          const ContactPointState &state = pair->committed()[i];
          if (!state.touching)
            continue;
          const unsigned int k = pair->node(problem.committed(), i).node;
          fields[0].values[k] = std::max(fields[0].values[k], state.penalty_factor);
          fields[1].values[k] = std::max(fields[1].values[k], state.penetration() / state.delta);
          fields[2].values[k] = std::max(fields[2].values[k], pressure[i]);
          fields[3].values[k] = std::max(fields[3].values[k], state.sticking ? 2. : 1.);
        }
      }
      return fields;
    }

    /// The pressures that act on each face in a stage, summed; a node of two faces shows the larger one.
    std::vector<double>
    load_pressure(const Actors &actors, const std::string &stage, const double time, const std::size_t n_nodes)
    {
      std::map<std::string, double> on_face;
      for (const auto &load : actors.loads)
        if (!load.face.empty() && load.acts_in(stage))
          on_face[load.face] += load.value(time);
      std::vector<double> result(n_nodes, 0.);
      for (const auto &[face, pressure] : on_face)
        for (const auto node : actors.blank->face_nodes(face))
          if (std::abs(pressure) > std::abs(result[node]))
            result[node] = pressure;
      return result;
    }

    /// The outline of a tool as lines, with its number.
    Drawing outline(const std::vector<Point2> &points, const double number)
    {
      Drawing drawing;
      drawing.points_per_cell = 2;
      drawing.points = points;
      for (unsigned int i = 1; i < points.size(); ++i)
        drawing.cells.insert(drawing.cells.end(), {i - 1, i});
      drawing.fields.push_back({"tool", "index", false, 1, std::vector<double>(drawing.cells.size() / 2, number)});
      return drawing;
    }
  } // namespace


  std::vector<DrawnField>
  Recorder::Files::nodal_fields(const FormingProblem &problem, const std::string &stage, const double time) const
  {
    const std::size_t n_nodes = scene.actors.blank->positions(problem.committed()).size();
    std::vector<DrawnField> fields;
    if (!scene.actors.tools.empty())
      fields = contact_fields(problem, n_nodes);
    const auto &loads = scene.actors.loads;
    if (std::any_of(loads.begin(), loads.end(), [](const Load &load) { return !load.face.empty(); }))
      fields.push_back({"load_pressure", "stress", true, 1, load_pressure(scene.actors, stage, time, n_nodes)});
    return fields;
  }


  void Recorder::Files::write_picture(const FormingProblem &problem, const std::string &stage, const double time)
  {
    const auto &blank = *scene.actors.blank;
    char number[16];
    std::snprintf(number, sizeof number, "_%04u", n_pictures++);
    std::vector<PictureSeries::Part> parts{{std::string("blank") + number + ".vtu", "blank"}};
    std::vector<Drawing> drawings{blank.draw(problem.committed(), nodal_fields(problem, stage, time))};

    double reach = 0.;
    for (const auto &x : blank.positions(problem.committed()))
      reach = std::max(reach, x.norm());
    // A part of its own for each tool: ParaView lists parts by name. Tools keep their number when others are absent.
    for (unsigned int i = 0; i < scene.actors.tools.size(); ++i)
      for (const auto *pair : problem.active_pairs())
        if (&pair->tool() == scene.actors.tools[i].get())
        {
          const auto points = pair->tool().polyline(pair->travel(problem.committed()), reach);
          if (points.size() < 2)
            continue;
          parts.push_back({std::string("tools") + number + "_" + std::to_string(i) + ".vtu", pair->tool().name()});
          drawings.push_back(outline(points, i));
        }
    last_picture = time;
    behind.run(
      [this, time, parts, drawings = std::move(drawings)]() {
        for (std::size_t part = 0; part < parts.size(); ++part)
          write_vtu(folder + "/" + parts[part].file, drawings[part], units);
        pictures.add(time, parts);
      });
  }
} // namespace deltaform
