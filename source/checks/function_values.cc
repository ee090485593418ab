#include <deltaform/checks/function_values.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltaform
{
  namespace
  {
    using Wrong = std::optional<WrongValue>;

    std::string at(const double time)
    {
      return " at t = " + text::format(time);
    }

    Wrong not_finite(const double value, const double time, const std::string &section, const std::string &name,
                     const std::string &entry)
    {
      if (std::isfinite(value))
        return {};
      return WrongValue{section, name, entry, "is no finite number" + at(time)};
    }

    /// Contact only pushes: a tool that is pulled leaves the blank and has no equilibrium.
    Wrong pulled(const Tool &tool, const Stage &stage, const double time)
    {
      const double force = tool.force(time);
      if (force >= 0.)
        return {};
      constexpr unsigned int n_samples = 200;
      double largest = 0.;
      for (unsigned int k = 0; k <= n_samples; ++k)
        largest = std::max(largest, std::abs(tool.force(stage.begin + (stage.end - stage.begin) * k / n_samples)));
      if (force >= -1e-12 * largest)
        return {};
      return WrongValue{"Tools", tool.name(), "Force",
                        "tool '" + tool.name() + "' is pulled off the blank" + at(time) + ", where its force is " +
                          text::rounded(force) +
                          ". A force is positive: it presses the tool along Direction against the blank. Turn "
                          "Direction round if that is what is meant, give the tool a Motion, or let it end with a "
                          "stage"};
    }

    Wrong wrong_tool(const Tool &tool, const Stage &stage, const double time)
    {
      if (!tool.exists_in(stage.name))
        return {};
      if (!tool.force_driven())
        return not_finite(tool.travel(time), time, "Tools", tool.name(), "Motion");
      if (auto wrong = not_finite(tool.force(time), time, "Tools", tool.name(), "Force"))
        return wrong;
      return pulled(tool, stage, time);
    }

    /// A load that lifts a tool leaves some of its force to the blank.
    Wrong wrong_lift(const Load &load, const Actors &actors, const Stage &stage, const double time)
    {
      for (const auto &tool : actors.tools)
        if (tool->name() == load.lifted_tool() && tool->force_driven() && tool->exists_in(stage.name))
        {
          const double lift = load.lift(time), force = tool->force(time);
          if (!std::isfinite(lift) || lift < 0.)
            return WrongValue{"Loads", load.name(), "Closing force",
                              "must be a number that is not negative" + at(time)};
          if (lift > 0. && lift >= force)
            return WrongValue{"Loads", load.name(), "Closing force",
                              "takes " + text::rounded(lift) + at(time) + ", and tool '" + tool->name() +
                                "' presses with " + text::rounded(force) + ": the bead would open it"};
        }
      return {};
    }

    Wrong wrong_support(const Support &support, const Stage &stage, const double time)
    {
      if (!support.acts_in(stage.name) || support.hold)
        return {};
      for (unsigned int i = 0; i < support.dofs.size() && (i == 0 || !support.values.empty()); ++i)
        if (auto wrong = not_finite(support.at(i, time), time, "Supports", support.name, "Value"))
          return wrong;
      return {};
    }
  } // namespace


  std::string WrongValue::to_string() const
  {
    return section + (name.empty() ? "" : "/" + name) + "/" + entry + " " + message;
  }


  FunctionValues::FunctionValues(const Actors &actors)
    : actors_(actors), size_(actors.blank->initial_thickness())
  {
    for (const auto &x : actors.blank->positions(Vector(actors.blank->n_dofs())))
      size_ = std::max(size_, x.norm());
  }


  std::optional<WrongValue> FunctionValues::find_wrong(const Stage &stage, const double time) const
  {
    for (const auto &tool : actors_.tools)
      if (auto wrong = wrong_tool(*tool, stage, time))
        return wrong;
    for (const auto &support : actors_.supports)
      if (auto wrong = wrong_support(support, stage, time))
        return wrong;
    for (const auto &load : actors_.loads)
      if (load->acts_in(stage.name))
      {
        if (auto wrong = not_finite(load->value()(time), time, "Loads", load->name(), "Value"))
          return wrong;
        if (auto wrong = wrong_lift(*load, actors_, stage, time))
          return wrong;
      }
    return actors_.tools.empty() ? std::nullopt : wrong_contact(stage, time);
  }


  std::optional<WrongValue> FunctionValues::wrong_contact(const Stage &stage, const double time) const
  {
    for (const auto &tool : actors_.tools)
      if (tool->exists_in(stage.name))
        if (auto wrong = wrong_delta(*tool, time))
          return wrong;
    return wrong_slip(time);
  }


  std::optional<WrongValue> FunctionValues::wrong_delta(const Tool &tool, const double time) const
  {
    const TimeFunction *own = tool.allowed_penetration();
    const TimeFunction &chosen = own != nullptr ? *own : actors_.contact->allowed_penetration;
    const auto wrong = [&](const std::string &message) {
      return WrongValue{own != nullptr ? "Tools" : "Contact", own != nullptr ? tool.name() : "", "Allowed penetration",
                        message};
    };
    const double delta = chosen(time);
    if (delta < 0 && std::isfinite(delta) && chosen.text().find("auto") != std::string::npos)
      return {}; // bounded below by a millionth of the thickness
    if (!(delta > 0) || !std::isfinite(delta))
      return wrong("must be positive at all times; it is " + text::format(delta) + at(time));
    // A coordinate is rounded by half an ulp.
    const double smallest = .5e6 * std::numeric_limits<double>::epsilon() * size_;
    if (actors_.contact->rule->promises() && actors_.contact->normal_law->uses_penalty() && delta < smallest)
      return wrong(text::format(delta) + at(time) + " cannot be told from round-off: at coordinates of size " +
                   text::rounded(size_) + " the noise of the contact forces exceeds 1e-6 of them below " +
                   text::rounded(smallest) +
                   ". Use Enforcement = active set, or the augmented Lagrangian, for contact that exact");
    return {};
  }


  std::optional<WrongValue> FunctionValues::wrong_slip(const double time) const
  {
    const auto has_friction = [](const auto &pair) { return pair->friction() != nullptr; };
    if (actors_.contact->tangential_factor > 0. ||
        std::none_of(actors_.interfaces.begin(), actors_.interfaces.end(), has_friction))
      return {};
    const double slip = actors_.contact->allowed_slip(time);
    if (std::isfinite(slip) && slip >= std::numeric_limits<double>::epsilon() * size_)
      return {};
    return WrongValue{"Contact", "", "Allowed elastic slip",
                      "must be positive, and more than the round-off of coordinates, at all times; it is " +
                        text::format(slip) + at(time)};
  }
} // namespace deltaform
