#include <deltaform/limits/necking.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace deltaform
{
  namespace
  {
    /// Over the initial thickness.
    double force(const SheetSection &section)
    {
      return section.stress * std::exp(-section.stretch);
    }

    std::size_t thinnest(const std::vector<SheetSection> &sections)
    {
      const auto thinner = [](const SheetSection &a, const SheetSection &b) { return a.thickness < b.thickness; };
      return static_cast<std::size_t>(std::min_element(sections.begin(), sections.end(), thinner) - sections.begin());
    }

    double median_size(std::vector<double> values)
    {
      std::transform(values.begin(), values.end(), values.begin(), [](const double v) { return std::abs(v); });
      std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
      return values[values.size() / 2];
    }

    /// Lengths of the undeformed meridian that belong to the nodes: half the way to either neighbour.
    std::vector<double> lengths(const std::vector<SheetSection> &sections)
    {
      std::vector<std::size_t> order(sections.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
        return sections[a].arc < sections[b].arc;
      });
      std::vector<double> result(sections.size(), 0.);
      for (std::size_t k = 1; k < order.size(); ++k)
      {
        const double half = .5 * (sections[order[k]].arc - sections[order[k - 1]].arc);
        result[order[k - 1]] += half;
        result[order[k]] += half;
      }
      return result;
    }

    /// Of random scenes past the maximum those that tear have at most 6, those that are held at least 14 (doc/decisions,
    /// "Torn, or held by a tool").
    constexpr double widest_neck = 10; // thicknesses

    /// A neck in one element, or at the node between two, is two such lengths wide.
    constexpr double narrowest_zone = 2.5; // lengths of a node

    /// Share of the zone that touches a tool which holds it, and width over the largest one so far of a zone that it
    /// still holds.
    constexpr double enough_touching = .5, enough_width = .9;
  } // namespace


  void NeckingWatch::observe(std::vector<SheetSection> sections)
  {
    if (sections.size() != now_.size())
    {
      // The first increment, or the new equilibrium after a refinement, at the same time: no increment to judge.
      before_ = now_ = std::move(sections);
      return;
    }
    before_ = std::move(now_);
    now_ = std::move(sections);
    ++n_since_;
    const std::optional<Neck> found = neck();
    if (!found)
    {
      n_necking_ = 0;
      lost_ = widest_ = 0.;
      held_ = false;
      return;
    }
    last_ = describe(*found);
    n_since_ = 0;
    thickness_then_ = now_[found->node].thickness;
    ++n_necking_;
    lost_ += found->fall;
    widest_ = found->node == node_ ? std::max(widest_, found->width) : found->width;
    node_ = found->node;
    held_ = found->may_be_held && found->width >= enough_width * widest_;
  }


  std::string NeckingWatch::holding() const
  {
    if (!past_maximum() || !held_)
      return "";
    const std::size_t i = thinnest(now_);
    return "the section of node " + std::to_string(i) + " at R0 = " + text::rounded(now_[i].place) +
           " stretches although its force falls (past Considere's maximum), so far by " + text::percent(lost_) +
           ". The tool on which it lies holds it, at a thickness of " + text::rounded(now_[i].thickness);
  }


  std::string NeckingWatch::suspicion() const
  {
    if (n_since_ == 0 || last_.empty() || now_.empty())
      return finding();
    const double thickness = now_[thinnest(now_)].thickness;
    if (n_since_ > recent_increments || !(thickness < thickness_then_))
      return "";
    return last_ + "; the thinnest place has " + text::rounded(thickness) + " now";
  }


  std::string NeckingWatch::at_once(std::vector<SheetSection> sections) const
  {
    if (sections.size() != now_.size())
      return "";
    for (std::size_t k = 0; k < sections.size(); ++k)
      sections[k].contact_pressure = now_[k].contact_pressure;
    NeckingWatch next = *this;
    next.observe(sections);
    const std::optional<Neck> found = next.neck();
    if (!found || found->may_be_held)
      return "";
    const SheetSection &node = sections[found->node];
    return "node " + std::to_string(found->node) + " at R0 = " + text::rounded(node.place) +
           " necks at once: its thickness falls from " + text::rounded(now_[found->node].thickness) + " to " +
           text::rounded(node.thickness) + " while its section force falls by " + text::percent(found->fall) +
           " (past Considere's maximum)";
  }


  std::string NeckingWatch::finding() const
  {
    const std::optional<Neck> found = neck();
    return found ? describe(*found) : "";
  }


  std::optional<NeckingWatch::Neck> NeckingWatch::neck() const
  {
    if (now_.empty() || before_.size() != now_.size())
      return {};
    const std::size_t i = thinnest(now_);
    std::vector<double> thinned;
    for (std::size_t k = 0; k < now_.size(); ++k)
      thinned.push_back(now_[k].thinning - before_[k].thinning);
    const double stretch = now_[i].stretch - before_[i].stretch;
    const double fall = 1 - force(now_[i]) / force(before_[i]);
    // A metal under plastic loading does not soften: d tau >= 0, so that F falls by no more than d eps. A node is the
    // mean of its neighbours. Where only one of them stretches, by d eps, and the other unloads with it, the stress of
    // which falls by up to d eps, the mean stretches by half of d eps and its force falls by up to all of it, to no less
    // than exp(-d eps) of what it was. A larger fall is unloading or bending, and no neck. A change in the last digits
    // is no change.
    const bool softens = now_[i].stress > 0 && before_[i].stress > 0 && fall > 1e-9 && stretch > 1e-9 &&
                         fall <= -std::expm1(-2.002 * stretch);
    if (!softens || !(thinned[i] > 3 * median_size(thinned)))
      return {};
    Neck neck{i, stretch, fall};
    measure_zone(thinned, neck);
    return neck;
  }


  void NeckingWatch::measure_zone(const std::vector<double> &thinned, Neck &neck) const
  {
    const std::vector<double> length = lengths(now_);
    double touching = 0;
    for (std::size_t k = 0; k < thinned.size(); ++k)
    {
      const double part = length[k] * std::max(0., thinned[k]) / thinned[neck.node];
      neck.width += part;
      if (now_[k].contact_pressure > 0.)
        touching += part;
    }
    neck.may_be_held =
      touching >= enough_touching * neck.width &&
      neck.width > std::max(widest_neck * now_[neck.node].thickness, narrowest_zone * length[neck.node]);
  }


  std::string NeckingWatch::describe(const Neck &neck) const
  {
    const SheetSection &node = now_[neck.node];
    return "node " + std::to_string(neck.node) + " at R0 = " + text::rounded(node.place) + " necks: its thickness is " +
           text::rounded(node.thickness) + ", in the last increment it stretched by " + text::rounded(neck.stretch) +
           " while its section force fell by " + text::percent(neck.fall) + " (past Considere's maximum)";
  }
} // namespace deltaform
