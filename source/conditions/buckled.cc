#include <deltaform/conditions/conditions.h>
#include <deltaform/conditions/turning_points.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <deal.II/base/numbers.h>

#include <boost/serialization/string.hpp>

#include <algorithm>
#include <limits>
#include <string>

namespace deltaform
{
  namespace
  {
    /// Has a wall buckled that carries the force of a tool as a strut does? It lies in waves then, and all balances are
    /// closed.
    class Buckled : public SavedCondition<Buckled>
    {
    public:
      explicit Buckled(const Actors &actors)
        : actors_(actors),
          // What a pressure bulges is meant to.
          is_watched_(!actors.tools.empty() &&
                      std::all_of(actors.loads.begin(), actors.loads.end(), [](const auto &load) {
                        return load->pressed_face().empty();
                      }))
      {
      }

      void observe(const AcceptedIncrement &increment) override
      {
        constexpr double looks = 20.; // at a stage
        const double pause = (increment.stage.end - increment.stage.begin) / looks;
        if (!is_watched_ || (!increment.ends_stage && increment.time < last_look_ + pause) ||
            increment.sections().empty())
          return;
        last_look_ = increment.time;
        const Wave wave = largest_wave(increment);
        if (wave.angle <= largest_)
          return;
        largest_ = wave.angle;
        text_ = "at time " + text::rounded(increment.time) + " the sheet lies in waves: it turns back by " +
                text::rounded(wave.angle / degree) + " degrees at r = " + text::rounded(wave.r) +
                ", z = " + text::rounded(wave.z) + ", where it carries force of tool '" + wave.tool + "' as a strut";
      }

      std::vector<std::string> warnings(bool) const override
      {
        if (!(largest_ > doubtful))
          return {};
        return {"buckled: " + text_ +
                ". When it buckles, and so the largest force, depends on small imperfections, and waves around the "
                "circumference are not followed. Form less, support the wall, or shorten it."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &largest_ &text_ &last_look_;
      }

    private:
      // The wall of a sound part turns into the direction of its tool and stays: it does not turn back (tubes that are
      // flared and nosed, doc/stress.md).
      static constexpr double degree = dealii::numbers::PI / 180., doubtful = 40. * degree;
      static constexpr double least_share = .25; // of the force of a tool along its way

      struct Wave
      {
        double angle = 0.; ///< by which the sheet turns back (rad)
        double r = 0., z = 0.; ///< where (length)
        std::string tool;
      };

      static std::size_t column(const Table &table, const std::string &name)
      {
        return static_cast<std::size_t>(std::find(table.names.begin(), table.names.end(), name) - table.names.begin());
      }

      Wave largest_wave(const AcceptedIncrement &increment) const
      {
        double force = 0.;
        Wave result;
        for (std::size_t i = 0; i < actors_.tools.size(); ++i)
          if (const double now = -(increment.model.tool_forces()[i] * actors_.tools[i]->direction()); now > force)
          {
            force = now;
            result.tool = actors_.tools[i]->name();
          }
        if (!(force > 0.))
          return {};
        const auto &sections = increment.sections();
        const bool axisymmetric = increment.model.blank().axisymmetric();
        const auto pressed_by = [&](const SheetSection &section, const double radius) {
          const double width = axisymmetric ? 2. * dealii::numbers::PI * radius : 1.;
          return -section.stress * section.thickness * width;
        };
        // A profile costs a tenth of an increment, and most sheets are pulled.
        constexpr double widened = 4.; // a radius that grows by more belongs to no wall
        if (std::none_of(sections.begin(), sections.end(), [&](const SheetSection &section) {
              return pressed_by(section, section.place) > least_share / widened * force;
            }))
          return {};
        const Table &profile = increment.profile();
        if (profile.rows.size() != sections.size())
          return {};
        const std::size_t r = column(profile, "r"), z = column(profile, "z"), rotation = column(profile, "rotation");
        TurningPoints strut;
        for (std::size_t i = 0; i < sections.size(); ++i)
        {
          const auto &row = profile.rows[i];
          if (pressed_by(sections[i], row[r]) < least_share * force)
          {
            strut = TurningPoints();
            continue;
          }
          strut.add(row[rotation]);
          for (const double swing : strut.swings(result.angle))
            if (swing > result.angle)
            {
              result.angle = swing;
              result.r = row[r];
              result.z = row[z];
            }
        }
        return result;
      }

      const Actors &actors_;
      bool is_watched_;
      double largest_ = 0.; ///< turn back (rad)
      std::string text_; ///< of that one
      double last_look_ = -std::numeric_limits<double>::infinity(); ///< time
    };

    const ConditionMakers::Entry
      entry("buckled", "a wall that is pressed along lies in waves", make_condition<Buckled>);
  } // namespace
} // namespace deltaform
