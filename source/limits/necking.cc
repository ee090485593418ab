#include <deltaform/limits/necking.h>
#include <deltaform/parameters/percent.h>
#include <deltaform/parameters/text.h>

#include <algorithm>
#include <cmath>

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
    if (std::string found = finding(); !found.empty())
    {
      last_ = std::move(found);
      n_since_ = 0;
      thickness_then_ = now_[thinnest(now_)].thickness;
    }
    else
    {
      n_necking_ = 0;
      lost_ = 0.;
      return;
    }
    const std::size_t i = thinnest(now_);
    ++n_necking_;
    lost_ += 1. - force(now_[i]) / force(before_[i]);
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


  std::string NeckingWatch::finding() const
  {
    if (now_.empty() || before_.size() != now_.size())
      return "";
    const std::size_t i = thinnest(now_);
    std::vector<double> rates;
    for (std::size_t k = 0; k < now_.size(); ++k)
      rates.push_back(std::abs(now_[k].thinning - before_[k].thinning));
    std::nth_element(rates.begin(), rates.begin() + rates.size() / 2, rates.end());
    const double median = rates[rates.size() / 2];

    const SheetSection &node = now_[i];
    const double stretch = node.stretch - before_[i].stretch;
    const double thinned = node.thinning - before_[i].thinning;
    const double fall = 1 - force(node) / force(before_[i]);
    // A metal under plastic loading does not soften: d tau >= 0, so that F falls by no more than d eps. A node is the
    // mean of its neighbours. Where only one of them stretches, by d eps, and the other unloads with it, the stress of
    // which falls by up to d eps, the mean stretches by half of d eps and its force falls by up to all of it. A larger
    // fall is unloading or bending, and no neck. A change in the last digits is no change.
    const bool softens =
      node.stress > 0 && before_[i].stress > 0 && fall > 1e-9 && stretch > 1e-9 && fall <= 2.002 * stretch;
    if (!softens || !(thinned > 3 * median))
      return "";
    return "node " + std::to_string(i) + " at R0 = " + text::rounded(node.place) + " necks: its thickness is " +
           text::rounded(node.thickness) + ", in the last increment it stretched by " + text::rounded(stretch) +
           " while its section force fell by " + text::percent(fall) + " (past Considere's maximum)";
  }
} // namespace deltaform
