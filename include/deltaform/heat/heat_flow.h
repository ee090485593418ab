#pragma once

#include <deltaform/blanks/blank.h>
#include <deltaform/contact/contact_interface.h>
#include <deltaform/heat/film.h>
#include <deltaform/heat/half_space.h>
#include <deltaform/heat/tool_heat.h>
#include <deltaform/io/keyed_arrays.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace deltaform
{
  /// Where the heat of the blank came from and went since the start (force*length: of the full circumference, or per
  /// unit width).
  struct HeatAccount
  {
    double stored = 0; ///< in the blank, over that at its initial temperature
    double flow = 0; ///< made by plastic flow; also what an earlier operation has left in the points
    double friction = 0; ///< the blank's share of it
    double tools = 0; ///< to the tools where they touch
    double surroundings = 0;

    /// stored - (flow + friction - tools - surroundings) over the largest of them.
    double error() const;
  };


  /**
   * Conduction in the blank, heat to the tools and the surroundings: one step of backward Euler after every accepted
   * increment, with forces, areas and places of its end (staggered). The points of the blank take the temperature that
   * comes out of it into the next increment. doc/theory/heat.md.
   */
  class HeatFlow
  {
  public:
    /// Read section Heat and those of the tools. Null if the blank does not conduct. @param interfaces one per tool
    static std::unique_ptr<HeatFlow> read(const Section &root,
                                          Blank &blank,
                                          const std::vector<std::unique_ptr<ContactInterface>> &interfaces);

    /// An increment of @p duration was accepted at @p q with contact at @p interfaces. All processes together.
    void advance(double duration, const Vector &q, const std::vector<ContactInterface *> &interfaces);

    /// Temperatures of all nodes, by their places in Blank::positions().
    std::vector<double> temperatures() const;

    /// Smallest and largest at the surfaces of all tools that are half-spaces; none: there is no such tool.
    std::optional<std::pair<double, double>> tool_temperatures() const;

    const HeatAccount &account() const
    {
      return account_;
    }

    /// @name The mesh is refined
    ///@{
    /// As a field for Adaptive::refine().
    const Vector &rise() const
    {
      return rise_;
    }
    void set_rise(const Vector &rise);
    ///@}

    /// Put the accepted state into that of the blank, or take it from there.
    void put(KeyedArrays &state) const;
    void take(const KeyedArrays &state);

  private:
    explicit HeatFlow(Blank &blank);

    /// What a node exchanges in an increment.
    struct Exchange
    {
      unsigned int node;
      double conductance; ///< times the duration (force*length/temperature)
      double outside; ///< rise of the temperature there
      double heat; ///< of friction (force*length)
    };

    /// What crosses a point of a half-space.
    struct Crossing
    {
      HalfSpace *half_space;
      unsigned int point;
      double area; ///< times the duration
      double flux; ///< of the tool's share of friction
      std::size_t first, end; ///< exchanges of the point
    };

    std::vector<Exchange> with_tools(double duration,
                                     const Vector &q,
                                     const std::vector<ContactInterface *> &interfaces,
                                     std::vector<bool> &touches,
                                     std::vector<Crossing> &crossings);
    std::vector<Exchange> with_surroundings(double duration, const Vector &q, const std::vector<bool> &touches) const;

    /// Heat that leaves by the exchanges, without that of friction.
    double lost(const std::vector<Exchange> &exchanges, std::size_t first, std::size_t end) const;

    /// End the increment of the half-spaces.
    void heat_tools(const std::vector<Exchange> &exchanges, const std::vector<Crossing> &crossings);

    /// Points that the blank has on a tool.
    unsigned int n_points(const Tool &tool) const;

    Blank &blank_;
    Conducting &conducting_;
    std::map<const Tool *, ToolHeat> tools_;
    std::map<const Tool *, HalfSpace> half_spaces_; ///< of those that are
    std::vector<Film> films_;
    Vector rise_; ///< over the initial temperature, see Conducting
    HeatAccount account_;
  };
} // namespace deltaform
