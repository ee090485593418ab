#pragma once

#include "material_points.h"
#include "shell_points.h"

#include <deltaform/assembly/side.h>

#include <array>
#include <vector>

namespace deltaform
{
  /// What a shell remembers besides the stress and history of its layers: their strain and its thickness, accepted and
  /// constant within an increment, and what presses on its faces.
  class ShellState
  {
  public:
    ShellState(const ShellSettings &settings, const ShellSpace &space, const ShellPoints &points);

    /// The mesh is another one: that of a new shell.
    void set_up();

    /// Strain of a material point.
    const Mandel &strain(const std::size_t point) const
    {
      return strain_[point];
    }

    /// Of the thickness at a quadrature point to the initial one.
    double thickness_ratio(const std::size_t point) const
    {
      return thickness_ratio_[point];
    }

    /// The same as the layers have it in the increment that is solved: that of its end, by the rate of the last one
    /// (doc/theory/shell.md).
    double layer_ratio(const std::size_t point) const
    {
      return layer_ratio_[point];
    }
    void set_layer_ratio(const std::size_t point, const double ratio)
    {
      layer_ratio_[point] = ratio;
    }

    /**
     * Accept the thickness of a quadrature point. @param force work of its stresses for a change of the layers' ratio
     * by one, on an area (force/length). @return the work of its stresses on an area as the layers moved since the last
     * increment: no virtual work belongs to it.
     */
    double accept_thickness(std::size_t point, double ratio, double force);

    double smallest_thickness() const;

    double node_thickness(const unsigned int node) const
    {
      return node_thickness_[node];
    }

    /// As contact sees it: the accepted one. Where the sheet thickens, that of the end of the increment, by the rate of
    /// the last one: the lag of the accepted one would be penetration that nobody asked for. Where it thins, the lag is
    /// a gap, and a thickness foreseen too small would be penetration.
    double face_thickness(const unsigned int node) const
    {
      return face_thickness_[node];
    }

    /// See Blank::begin_increment().
    void begin_increment(double ratio);

    /// The arrays were replaced: what follows from them.
    void renew();

    /// By how much a face of the node would spring back if nothing pressed on it: the elastic part of half the
    /// thickness (length).
    double node_recovery(const unsigned int node) const
    {
      return node_recovery_[node];
    }

    /// Mean over one thickness, accepted (stress).
    double contact_pressure(const Side side, const unsigned int node) const
    {
      return contact_pressure_[static_cast<unsigned int>(side)][node];
    }

    /// See Blank::set_pressure(). @p areas of the nodes
    void set_contact_pressure(const FaceValues &pressure, const std::vector<double> &areas);

    /// The largest one that this pressure would make, at the nodes (stress).
    double change_of_transverse_stress(const FaceValues &pressure, const std::vector<double> &areas) const;

    /// Transverse stress of material points, from @p first on.
    const double *third_stress(const std::size_t first) const
    {
      return &third_stress_[first];
    }

    /// Accept the strains of the layers, after the thickness of all points. @p modulus: Young's
    void commit(const std::vector<Mandel> &strains, double modulus);

    /// Every array of the state with its name.
    template <typename State, typename Action>
    static void each_array(State &state, const Action &action)
    {
      action("strain", state.strain_);
      action("thickness ratio", state.thickness_ratio_);
      action("change of thickness ratio", state.ratio_change_);
      action("ratio of layers", state.accepted_layer_ratio_);
      action("force on the ratio of layers", state.layer_force_);
      action("thickness at nodes", state.node_thickness_);
      action("change of thickness at nodes", state.thickness_change_);
      action("elastic recovery at nodes", state.node_recovery_);
      action("contact pressure, bottom", state.contact_pressure_[0]);
      action("contact pressure, top", state.contact_pressure_[1]);
    }

  private:
    /// Pressure at the nodes, averaged over one thickness.
    void average(const std::vector<double> &pressure,
                 const std::vector<double> &areas,
                 std::vector<double> &mean) const;
    void update_third_stress();

    const ShellSpace &space_;
    const ShellPoints &points_;
    bool transverse_normal_stress_;
    std::vector<Mandel> strain_;
    std::vector<double> thickness_ratio_, ratio_change_; ///< of the quadrature points; in the last increment
    std::vector<double> layer_ratio_, accepted_layer_ratio_; ///< of the increment that is solved, of the last one
    std::vector<double> layer_force_; ///< accepted
    std::vector<double> node_thickness_, node_recovery_;
    std::vector<double> thickness_change_; ///< at the nodes, in the last increment
    std::vector<double> face_thickness_; ///< of the increment that is solved; not kept: each one begins with it
    FaceValues contact_pressure_, present_pressure_; ///< accepted; in the increment that is solved
    std::vector<double> third_stress_; ///< of the material points, by the present pressure
  };
} // namespace deltaform
