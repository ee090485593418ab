#include <deltaform/conditions/conditions.h>
#include <deltaform/parameters/text.h>
#include <deltaform/reports/accepted_increment.h>

#include <algorithm>

namespace deltaform
{
  namespace
  {
    /// Does a support keep its part of the boundary on the line r = 0, where it cannot turn either and slides along the
    /// line? Where z is held as well the blank is clamped, and need not have another half.
    bool on_line_of_symmetry(const Support &support, const AcceptedIncrement &increment)
    {
      const Actors &actors = increment.model.actors();
      const Boundary &boundary = actors.blank->boundary();
      if (support.component != Component::r || support.hold || !support.acts_in(increment.stage.name) ||
          support.at(0, increment.time) != 0.)
        return false;
      const auto points = boundary.points(support.boundary);
      if (std::any_of(points.begin(), points.end(), [](const Point2 &X) { return X[0] != 0.; }))
        return false;
      const auto held = [&](const Component component) {
        return std::any_of(actors.supports.begin(), actors.supports.end(), [&](const Support &other) {
          return other.boundary == support.boundary && other.component == component &&
                 other.acts_in(increment.stage.name);
        });
      };
      const bool may_turn = !boundary.dofs(support.boundary, Component::rotation).empty();
      return !held(Component::z) && (!may_turn || held(Component::rotation));
    }


    /// Does the blank cross the line r = 0 on which it is cut in half? The other half would meet it there, and nothing
    /// else keeps it from going on: contact is between blank and tools only.
    class CrossedLine : public SavedCondition<CrossedLine>
    {
    public:
      explicit CrossedLine(const Actors &actors)
        : length_(actors.blank->typical_length()), symmetric_(actors.blank->axisymmetric())
      {
        for (const auto &X : actors.blank->positions(Vector(actors.blank->n_dofs())))
          starts_beyond_ |= X[0] < 0.;
      }

      void observe(const AcceptedIncrement &increment) override
      {
        const Actors &actors = increment.model.actors();
        if (starts_beyond_ || actors.tools.empty())
          return;
        for (const auto &support : actors.supports)
          symmetric_ = symmetric_ || on_line_of_symmetry(support, increment);
        if (!symmetric_)
          return;
        const InnermostPlace &now = increment.innermost_place();
        if (now.r >= r_)
          return;
        r_ = now.r;
        node_ = now.node;
        place_ = now.place;
        number_ = increment.number;
      }

      std::string failure(const Stage &) override
      {
        // As much as a sheet may lie within itself (self_contact.cc); of a solid, shares of its shortest edge.
        constexpr double largest = .1;
        if (-r_ <= largest * length_)
          return "";
        return "the blank crosses its line of symmetry r = 0: node " + std::to_string(node_) + " (R0 = " +
               text::rounded(place_) + ") lies " + text::rounded(-r_) + " beyond it after increment " +
               std::to_string(number_) +
               ", where the other half is. Contact is between blank and tools only: end the stage before, or put a "
               "tool on the line";
      }

      template <class Archive>
      void serialize(Archive &archive, unsigned int)
      {
        archive &symmetric_ &r_ &node_ &place_ &number_;
      }

    private:
      double length_;
      bool starts_beyond_ = false, symmetric_;
      double r_ = 0., place_ = 0.; ///< of the worst increment
      unsigned int node_ = 0, number_ = 0;
    };

    const ConditionMakers::Entry
      entry("crossed line", "a blank crosses its line of symmetry; ends the run", make_condition<CrossedLine>);
  } // namespace
} // namespace deltaform
