#include <deltaform/conditions/conditions.h>
#include <deltaform/contact/contact_measures.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /**
     * Do two tools that have their places press both faces of a shell within a thickness? Between them it is no thin
     * sheet: what it resists follows from stresses through the thickness that a shell does not have, and where they
     * leave no gap from how it flows through its thickness. A tool with a force finds its own place: what it presses
     * with is right.
     */
    class SqueezedShell : public SavedCondition<SqueezedShell>
    {
    public:
      void observe(const AcceptedIncrement &increment) override
      {
        const auto &sections = increment.sections();
        FaceValues placed;
        for (std::size_t i = 0; i < sections.size(); ++i)
        {
          const SheetSection &section = sections[i];
          if (!(section.flow_stress > 0. &&
                section.clamping_pressure > std::max(doubtful, share_) * section.flow_stress))
            continue;
          if (placed[0].empty())
            placed = pressure_of_placed_tools(increment.model, sections.size());
          if (!are_both_pressed(sections, placed, i))
            continue;
          share_ = section.clamping_pressure / section.flow_stress;
          place_ = section.place;
          time_ = increment.time;
        }
      }

      std::vector<std::string> warnings(bool) const override
      {
        if (!(share_ > doubtful))
          return {};
        return {"squeezed shell: at time " + text::rounded(time_) +
                " two tools press both faces within a thickness, at R0 = " + text::rounded(place_) + " with " +
                text::rounded(share_) +
                " of the flow stress. A shell does not know what happens through its thickness: forces may be off by "
                "a fifth, by any factor where the tools leave no gap, and angles after springback by a degree. Model "
                "the blank as a solid of degree 2 (Blank/Kind = solid), give the tools more clearance or larger radii, "
                "or give one of them a Force."};
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &share_ &place_ &time_;
      }

    private:
      static constexpr double doubtful = .15; // doc/stress.md, A shell or a solid

      static FaceValues pressure_of_placed_tools(const Model &model, const std::size_t n_nodes)
      {
        FaceValues result;
        result.fill(std::vector<double>(n_nodes, 0.));
        for (const auto *interface : model.interfaces())
          if (!interface->tool().force_driven())
            add_contact_pressure(*interface, interface->committed(), model.committed(), result);
        return result;
      }

      /// Clamping pressures are means over one thickness: so far away may the tools touch.
      static bool
      are_both_pressed(const std::vector<SheetSection> &sections, const FaceValues &pressure, const std::size_t i)
      {
        return std::all_of(pressure.begin(), pressure.end(), [&](const std::vector<double> &face) {
          for (std::size_t k = 0; k < sections.size(); ++k)
            if (face[k] > 0. && std::abs(sections[k].place - sections[i].place) <= sections[i].thickness)
              return true;
          return false;
        });
      }

      double share_ = 0.; ///< largest clamping pressure over the flow stress
      double place_ = 0.; ///< R0 (length)
      double time_ = 0.;
    };

    const ConditionMakers::Entry entry("squeezed shell",
                                       "a shell is squeezed between two tools whose gap is given",
                                       make_condition<SqueezedShell>);
  } // namespace
} // namespace deltaform
