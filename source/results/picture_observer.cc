// blank_*.vtu, tools_*.vtu and scene.pvd: what stands in the pictures.
#include <deltaform/contact/contact_measures.h>
#include <deltaform/io/picture_series.h>
#include <deltaform/io/vtu.h>
#include <deltaform/parameters/command_line.h>
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/results/observers.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace deltaform
{
  namespace
  {
    std::vector<DrawnField> contact_fields(const Model &model, const std::size_t n_nodes)
    {
      const std::vector<double> none(n_nodes, 0.);
      std::vector<DrawnField> fields{{"penalty_factor", "force/length", true, 1, none},
                                     {"penetration_over_delta", "1", true, 1, none},
                                     {"contact_pressure", "stress", true, 1, none},
                                     {"contact_status", "0 free 1 slip 2 stick", true, 1, none}};
      for (const auto *interface : model.interfaces())
      {
        const auto pressure = contact_pressure(*interface, interface->committed(), model.committed(), n_nodes);
        std::transform(pressure.begin(), pressure.end(), fields[2].values.begin(), fields[2].values.begin(),
                       [](const double a, const double b) { return std::max(a, b); });
        for (unsigned int i = 0; i < interface->n_points(); ++i)
        {
          const ContactPointState &state = interface->committed()[i];
          if (!state.touching)
            continue;
          const ContactPoint point = interface->point(model.committed(), i);
          for (unsigned int a = 0; a < point.n_nodes; ++a)
          {
            const unsigned int k = point.nodes[a].node;
            fields[0].values[k] = std::max(fields[0].values[k], state.penalty_factor);
            fields[1].values[k] = std::max(fields[1].values[k], state.penetration() / state.delta);
            fields[3].values[k] = std::max(fields[3].values[k], state.sticking ? 2. : 1.);
          }
        }
      }
      return fields;
    }

    /// The pressures that act on each face in a stage, summed; a node of two faces shows the larger one.
    std::vector<double>
    load_pressure(const Model &model, const std::string &stage, const double time, const std::size_t n_nodes)
    {
      const Actors &actors = model.actors();
      std::map<std::string, double> on_face;
      for (const auto &load : actors.loads)
        if (const std::string face = load->pressed_face(); !face.empty() && load->acts_in(stage))
          on_face[face] += load->size(model.committed(), time);
      std::vector<double> result(n_nodes, 0.);
      for (const auto &[face, pressure] : on_face)
        for (const auto node : actors.blank->boundary().face_nodes(face))
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


    /// Values at the nodes of the blank: contact, pressures that act on it, temperature.
    std::vector<DrawnField> nodal_fields(const Model &model, const std::string &stage, const double time)
    {
      const Actors &actors = model.actors();
      const std::size_t n_nodes = actors.blank->positions(model.committed()).size();
      std::vector<DrawnField> fields;
      if (!actors.tools.empty())
        fields = contact_fields(model, n_nodes);
      const auto &loads = actors.loads;
      if (std::any_of(loads.begin(), loads.end(), [](const auto &load) { return !load->pressed_face().empty(); }))
        fields.push_back({"load_pressure", "stress", true, 1, load_pressure(model, stage, time, n_nodes)});
      if (actors.heat)
        fields.push_back({"temperature", "temperature", true, 1, actors.heat->temperatures()});
      return fields;
    }

    class PictureObserver : public Observer
    {
    public:
      PictureObserver(ResultsFolder &folder, const OutputSettings &output)
        : folder_(folder), output_(output), series_(std::make_shared<PictureSeries>(folder.path("scene.pvd")))
      {
      }

      /// The picture that opens the series shows the undeformed blank and the tools at their start.
      void begin(const Model &model, const Stage &stage) override
      {
        if (!output_.frame_times.empty())
          write(model, stage.name, 0.);
      }

      void accepted(const AcceptedIncrement &increment) override
      {
        time_ = increment.time;
        stage_ = increment.stage.name;
        if (increment.is_last_here && pass_frames())
          write(increment.model, stage_, time_);
      }

      void moved(const AcceptedIncrement &increment) override
      {
        time_ = increment.time;
        stage_ = increment.stage.name;
        next_frame_ = 0;
        pass_frames();
      }

      /// Other numbers of pictures or stages that end later may be asked for now: see moved().
      void resumed(const AcceptedIncrement &) override
      {
        n_pictures_ = series_->size();
      }

      /// A run that stopped shows its last state, once.
      void ended(const Model &model, const RunOutcome &outcome) override
      {
        if (outcome.stopped_by_itself() && outcome.increments > 0 && last_picture_ != time_)
          write(model, stage_, time_);
      }

      void save(boost::archive::binary_oarchive &archive) const override
      {
        archive << last_picture_;
      }

      void load(boost::archive::binary_iarchive &archive) override
      {
        archive >> last_picture_;
        series_->resume(last_picture_);
      }

    private:
      /// Go to the first time that is still to come. @return was there one before it?
      bool pass_frames()
      {
        const auto &frames = output_.frame_times;
        const unsigned int before = next_frame_;
        while (next_frame_ < frames.size() && time_ >= frames[next_frame_] * (1 - 1e-12))
          ++next_frame_;
        return next_frame_ > before;
      }

      /// Blank and tools as files, and as an entry of the series.
      void write(const Model &model, const std::string &stage, const double time)
      {
        const Blank &blank = model.blank();
        const auto &all_tools = model.actors().tools;
        const unsigned int picture = n_pictures_++;
        std::vector<PictureSeries::Part> parts{{fmt::format("blank_{:04}.vtu", picture), "blank"}};
        std::vector<Drawing> drawings{blank.fields().draw(model.committed(), nodal_fields(model, stage, time))};

        double reach = 0.;
        for (const auto &x : blank.positions(model.committed()))
          reach = std::max(reach, x.norm());
        // A part of its own for each tool: ParaView lists parts by name. Tools keep their number when others are
        // absent.
        for (unsigned int i = 0; i < all_tools.size(); ++i)
          for (const auto *interface : model.interfaces())
            if (&interface->tool() == all_tools[i].get())
            {
              const auto points = interface->tool().polyline(interface->travel(model.committed()), reach);
              if (points.size() < 2)
                continue;
              parts.push_back({fmt::format("tools_{:04}_{}.vtu", picture, i), interface->tool().name()});
              drawings.push_back(outline(points, i));
            }
        last_picture_ = time;
        folder_.writer().run([series = series_, folder = folder_.name(), units = folder_.units(), time, parts,
                              drawings = std::move(drawings)]() {
          for (std::size_t part = 0; part < parts.size(); ++part)
            write_vtu(folder + "/" + parts[part].file, drawings[part], units);
          series->add(time, parts);
        });
      }

      ResultsFolder &folder_;
      const OutputSettings &output_;
      std::shared_ptr<PictureSeries> series_; ///< written by the background tasks
      double time_ = 0.; ///< of the last accepted increment, and its stage
      std::string stage_;
      unsigned int n_pictures_ = 0, next_frame_ = 0;
      double last_picture_ = -1.; ///< its time
    };

    const ObserverMakers::Entry
      entry("pictures", "blank_*.vtu, tools_*.vtu and scene.pvd", make_observer<PictureObserver>);
  } // namespace
} // namespace deltaform
