#pragma once

#include <deltaform/blanks/sheet_section.h>
#include <deltaform/io/archive.h>

#include <optional>
#include <string>
#include <vector>

namespace deltaform
{
  /**
   * Finds out whether a sheet that cannot be formed any further necks. The section force of a node, per unit initial
   * width, is F = tau h0 exp(-eps), tau the mean meridional stress (Kirchhoff) and eps the meridional strain. In
   * tension it grows with the strain until d tau/d eps = tau (Considere 1885): a node whose section stretches although
   * its force falls has lost its load-bearing capacity (a fall of more than twice the stretch is unloading), and what
   * else the sheet is asked to give comes from there. A neck is that at the node with the smallest thickness, thinning
   * at least three times as fast as the blank's median node.
   *
   * A tool on which the sheet lies, by its friction and its curvature, can hold a section that is past this maximum: the
   * zone that thins is wide and spreads. A sheet that tears does so in a narrow zone, in one that narrows, or away from
   * the tools. The width of the zone is that of one that thins evenly at the rate of its thinnest node, w =
   * integral of max(d eps_t, 0) over the undeformed meridian / d eps_t of that node.
   */
  class NeckingWatch
  {
  public:
    /// @param sections of the blank after an accepted increment; none if it is no sheet
    void observe(std::vector<SheetSection> sections);

    /// "node 12 at R0 = 0.9 necks: ...", or empty if the last increment shows no neck.
    std::string finding() const;

    /// What has most likely ended a run: the last increments showed a neck, and the sheet has thinned further.
    std::string suspicion() const;

    /// "node 12 at R0 = 0.9 necks at once: ...", or empty: the step to the equilibrium with these @p sections, which is
    /// not accepted because it strains too much, is a neck. They touch the tools where the last ones do.
    std::string at_once(std::vector<SheetSection> sections) const;

    /// Is the sheet torn? Then it has necked in so many increments in a row, the section there has lost so much of its
    /// force meanwhile, and no tool holds it. A smaller loss may be made up for: friction and bending can hold a
    /// section a little past its maximum.
    bool torn() const
    {
      return past_maximum() && !held_;
    }

    /// "the section of node 12 at R0 = 0.9 stretches although its force falls, ...", or empty. The same as torn, but for
    /// a tool that holds the sheet.
    std::string holding() const;

    template <class Archive>
    void serialize(Archive &archive, unsigned int)
    {
      archive_plain(archive, before_);
      archive_plain(archive, now_);
      archive &n_necking_ &lost_ &node_ &widest_ &held_ &last_ &n_since_ &thickness_then_;
    }

  private:
    /// What an increment shows at the thinnest node.
    struct Neck
    {
      std::size_t node;
      double stretch, fall; ///< by which the node stretched, and share of its force that it lost
      double width = 0; ///< of the zone that thins (length)
      bool may_be_held = false; ///< does the zone lie on a tool, and is it wider than a neck?
    };

    static constexpr unsigned int enough_increments = 5;
    static constexpr double enough_loss = .01;
    static constexpr unsigned int recent_increments = 5;

    bool past_maximum() const
    {
      return n_necking_ >= enough_increments && lost_ >= enough_loss;
    }

    std::optional<Neck> neck() const;
    void measure_zone(const std::vector<double> &thinned, Neck &neck) const;
    std::string describe(const Neck &neck) const;

    std::vector<SheetSection> before_, now_;
    unsigned int n_necking_ = 0; ///< increments in a row with a finding
    double lost_ = 0; ///< share of the section force that was lost in them
    std::size_t node_ = 0; ///< of the last of them
    double widest_ = 0; ///< largest width of the zone while that node was the thinnest (length)
    bool held_ = false; ///< did a tool hold the sheet in the last of them?
    std::string last_; ///< finding, so many increments ago, with that thickness
    unsigned int n_since_ = 0;
    double thickness_then_ = 0;
  };
} // namespace deltaform
