#pragma once

#include <deltaform/blanks/blank.h>

#include <string>
#include <vector>

namespace deltaform
{
  class Section;

  /**
   * Heat between parts of the boundary and what surrounds them, air or a bath: the flux h (T - T_s), h a constant film
   * coefficient for convection and radiation together. An edge all of whose nodes touch tools has none.
   */
  class Film
  {
  public:
    /// Read a subsection of Heat. @throws SceneError if the blank has no such parts, or would melt
    Film(Section section, Blank &blank);

    /// The shares of the boundary that are open to it now.
    template <typename Action> // (node, area)
    void each_area(const Conducting &blank,
                   const Vector &q,
                   const std::vector<bool> &touches,
                   const Action &action) const
    {
      for (const auto &part : parts_)
        for (const auto &edge : blank.edges(q, part))
        {
          bool open = false;
          for (unsigned int a = 0; a < edge.n_nodes; ++a)
            open = open || !touches[edge.nodes[a]];
          for (unsigned int a = 0; open && a < edge.n_nodes; ++a)
            action(edge.nodes[a], edge.areas[a]);
        }
    }

    /// h (force/length/time/temperature).
    double coefficient() const
    {
      return coefficient_;
    }

    /// Over the initial temperature of the blank.
    double rise() const
    {
      return rise_;
    }

  private:
    std::vector<std::string> parts_;
    double coefficient_, rise_;
  };
} // namespace deltaform
