// A draw bead: a line force along r that opposes the sheet's way past a place (see BeadLine), and holds the tool down
// that closes it.
#include "bead_line.h"

#include <deltaform/loads/load.h>
#include <deltaform/materials/repeated_bending.h>
#include <deltaform/parameters/section.h>

#include <cmath>
#include <map>
#include <utility>

namespace deltaform
{
  namespace
  {
    class DrawBead : public Load
    {
    public:
      DrawBead(Section &section, const Blank &blank)
        : Load(section, blank,
               {"force/length", "Restraining force of the bead per length of it as a function of time t. With 'Bend "
                                "radii': what the force computed from them is multiplied by (1: as computed)."}),
          boundary_(blank.boundary()), lengths_(read_lengths(section, blank)),
          width_(blank.axisymmetric() ? 2. * dealii::numbers::PI * lengths_.place : 1.),
          computed_(read_geometry(section, blank)),
          closes_(section.text("Closes", "", "Tool under a force that closes the bead; empty: none.")),
          closing_force_(section.function("Closing force", "0", "force/length",
                                          "What the closed bead takes of that tool's force, per length of the bead, as "
                                          "a function of time t."))
      {
        for (auto &nodes : boundary_.lines())
          lines_.emplace_back(lengths_, std::move(nodes));
        if (lines_.empty())
          section.fail("Kind", "a draw bead holds a sheet: a shell, or a solid given by its meridian and thickness");
        const Vector undeformed(blank.n_dofs());
        for (auto &line : lines_)
        {
          line.begin(undeformed);
          if (!section.documentation() && !line.passes(undeformed))
            section.fail("Place", "the undeformed sheet does not reach there");
        }
      }

      void add(const Vector &q, const double value, AssemblyTarget &target) const override
      {
        for (const auto &line : lines_)
          line.add(q, force(value) / lines_.size(), target);
      }

      void renumber() override
      {
        const auto nodes = boundary_.lines();
        for (unsigned int i = 0; i < lines_.size(); ++i)
          lines_[i].renumber(nodes[i]);
      }

      void begin(const Vector &q) override
      {
        for (auto &line : lines_)
          line.begin(q);
        restraint_ = 0.;
      }

      void accept(const Vector &q, const double time, double /*duration*/) override
      {
        const double held = force(size(q, time));
        const double before = restraint_;
        double passed = 0.;
        restraint_ = 0.;
        for (auto &line : lines_)
        {
          const BeadHistory next = line.next(q);
          passed += (next.material - line.history.material) / lines_.size();
          restraint_ += held * next.share / lines_.size();
          line.history = next;
        }
        work_ += .5 * (before + restraint_) * passed;
      }

      std::vector<double> history() const override
      {
        std::vector<double> result{restraint_, work_};
        for (const auto &line : lines_)
          result.insert(result.end(), {line.history.material, line.history.share, line.history.path});
        return result;
      }

      void set_history(const std::vector<double> &values) override
      {
        restraint_ = values[0];
        work_ = values[1];
        for (unsigned int i = 0; i < lines_.size(); ++i)
          lines_[i].history = {values[3 * i + 2], values[3 * i + 3], values[3 * i + 4]};
      }

      std::string lifted_tool() const override
      {
        return closes_;
      }

      double lift(const double time) const override
      {
        return closes_.empty() ? 0. : width_ * closing_force_(time);
      }

      std::optional<Restraint> restraint() const override
      {
        return Restraint{restraint_ / width_, lines_.front().history.path, work_};
      }

    private:
      static BeadLengths read_lengths(Section &section, const Blank &blank)
      {
        const std::map<std::string, double> constants{{"thickness", blank.initial_thickness()}};
        BeadLengths result{};
        result.place =
          section.number("Place", required(.5), Range::any(), "length", "r of the bead, which the sheet passes.");
        result.length = section.number("Length", required(.1), Range::positive(), "length",
                                       "Path through the bead: so much sheet must pass until it holds fully.");
        result.elastic_slip = section.function("Elastic slip", "thickness/100", "length",
                                               "Slip over which the force reverses where the sheet turns back.",
                                               constants)(0.);
        if (!(result.elastic_slip > 0.) || !std::isfinite(result.elastic_slip) || result.elastic_slip > result.length)
          section.fail("Elastic slip", "must be positive, and at most the length of the bead");
        if (blank.axisymmetric() && !(result.place > 0.))
          section.fail("Place", "must be positive: a bead around the axis has a radius");
        return result;
      }

      /// Force per length that follows from the geometry of the bead; 1 if that is not given.
      static double read_geometry(Section &section, const Blank &blank)
      {
        const auto radii = section.numbers("Bend radii", "", "length",
                                           "Radii of the mid-surface to which the sheet is bent in the bead one way, "
                                           "then the other, and straightened each time. Empty: the force is given.");
        for (const double radius : radii)
          if (!(radius > .5 * blank.initial_thickness()))
            section.fail("Bend radii", "a radius of the mid-surface is larger than half the thickness");
        if (radii.empty())
          return 1.;
        Section material = section.root().sub("Material");
        const auto law = Registry<Material>::choose(material, "Model", "elastoplastic", "Stress-strain law.");
        if (!law->traits().stress_given)
          section.fail("Bend radii", "the law of the metal cannot be asked for plane stress: give the force itself");
        const auto force = drawing_force(*law, blank.initial_thickness(), radii);
        if (!force)
          section.fail("Bend radii", "no force draws this sheet through: it would tear, or its law gives no stress");
        return *force;
      }

      double force(const double value) const
      {
        return value * computed_ * width_;
      }

      const Boundary &boundary_;
      BeadLengths lengths_;
      double width_; ///< length of the bead
      double computed_; ///< force per length that Value multiplies
      std::string closes_;
      TimeFunction closing_force_;
      std::vector<BeadLine> lines_;
      double restraint_ = 0., work_ = 0.; ///< accepted
    };

    const LoadRegistry::Entry entry("draw bead", "opposes the sheet's way past a place", make_as<DrawBead, Load>);
  } // namespace
} // namespace deltaform
