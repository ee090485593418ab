#pragma once
// The work at one cell of a shell, step by step: derivation in doc/theory/shell.md.
#include "elastic_core.h"
#include "layer_motion.h"
#include "material_points.h"
#include "shell_state.h"
#include "shell_work.h"

#include <array>
#include <cmath>
#include <vector>

namespace deltaform
{
  /// A cell: strains of its layers from the unknowns, forces and tangent from the stresses that the law has found.
  template <unsigned int n_nodes, bool membrane>
  class ShellCell
  {
  public:
    static constexpr unsigned int n_dofs = 3 * n_nodes;

    /// @param stiffness of transverse shear, see ShellKernel @param tangent are tangents wanted?
    ShellCell(const ShellSpace &space, const ShellPoints &points, const ShellState &state, MaterialPoints &material,
              const ElasticCore &core, const double stiffness, const bool tangent)
      : space_(space), points_(points), state_(state), material_(material), core_(core),
        axisymmetric_(space.axisymmetric()), tangent_(tangent), n_points_(points.per_cell()),
        n_layers_(points.n_layers()), stiffness_(stiffness),
        moduli_(tangent ? n_points_ * n_layers_ * 16 : 0), layers_(n_points_ * n_layers_)
    {
      strains_.reserve(n_points_);
    }

    void enter(const unsigned int cell)
    {
      cell_ = cell;
      const auto &nodes = space_.mesh().cells()[cell].nodes;
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int k = 0; k < 3; ++k)
          dofs_[3 * a + k] = space_.dofs()[nodes[a]][k];
    }

    /// Logarithmic strains of all layers of all points. @return false if a layer is turned inside out
    bool set_strains(const Vector &q)
    {
      strains_.clear();
      for (unsigned int p = 0; p < n_points_; ++p)
      {
        const ShellPoint &point = points_[cell_ * n_points_ + p];
        strains_.push_back(shell_strain<n_nodes, membrane>(point, space_.mesh().cells()[cell_], space_.mesh().nodes(),
                                                           q, dofs_.data(), axisymmetric_));
        const LayerMotion motion = motion_of(p);
        for (unsigned int l = 0; l < n_layers_; ++l)
        {
          const unsigned int i = p * n_layers_ + l;
          const double position = points_.layer_position(l);
          const auto [a1, a2] = motion.now(position);
          const auto [a1_zero, a2_zero] = motion.before(position);
          if (!(a1 > 0) || !(a2 > 0))
            return false;
          Mandel &e = material_.strain(first() + i);
          e[0] = std::log(a1 / a1_zero);
          e[1] = axisymmetric_ ? std::log(a2 / a2_zero) : 0.;
          e[3] = 0.;
          layers_[i] = {1. / a1, 1. / a2, motion.distance(position),
                        point.weight * points_.layer_weight(l) * a1_zero * a2_zero};
        }
      }
      return true;
    }

    /// By the law.
    Status update_stresses()
    {
      return material_.update(first(), n_points_ * n_layers_, tangent_ ? moduli_.data() : nullptr,
                              state_.third_stress(first()));
    }

    /// Forces and, where it is wanted, the tangent.
    void add_up()
    {
      residual_.fill(0.);
      if (tangent_)
        matrix_.fill(0.);
      for (unsigned int p = 0; p < n_points_; ++p)
      {
        const ShellPoint &point = points_[cell_ * n_points_ + p];
        Resultants total;
        for (unsigned int l = 0; l < n_layers_; ++l)
          add_layer(layers_[p * n_layers_ + l], material_.stress(first() + p * n_layers_ + l),
                    tangent_ ? &moduli_[16 * (p * n_layers_ + l)] : nullptr, total);
        if (core_.follows())
          add_corrections(p, total);
        const double shear = stiffness_ * point.weight * point.radius;
        total.n[ShellStrain::shear] = shear * (strains_[p].gamma - point.gamma);
        total.g[4][4] = shear;
        total.g[1][0] = total.g[0][1];
        total.g[3][2] = total.g[2][3];
        add_point<n_nodes, membrane>(point, strains_[p], total.n, total.g, tangent_, residual_, matrix_);
      }
    }

    /// Into the equations.
    void add_to(AssemblyTarget &target) const
    {
      target.add(dofs_.data(), n_dofs, tangent_ ? matrix_.data() : nullptr, residual_.data());
    }

  private:
    /// Over the thickness: generalized stresses and their derivatives by the generalized strains.
    struct Resultants
    {
      std::array<double, ShellStrain::size> n{};
      std::array<std::array<double, ShellStrain::size>, ShellStrain::size> g{};
    };

    /// Inverse stretches, distance from the mid-surface, weight.
    struct Layer
    {
      double i1, i2, zeta, weight;
    };

    std::size_t first() const
    {
      return static_cast<std::size_t>(cell_) * n_points_ * n_layers_;
    }

    LayerMotion motion_of(const unsigned int p) const
    {
      const std::size_t place = static_cast<std::size_t>(cell_) * n_points_ + p;
      return {points_[place], strains_[p], state_.layer_ratio(place), axisymmetric_};
    }

    void add_corrections(const unsigned int p, Resultants &total)
    {
      const LayerMotion motion = motion_of(p);
      core_.corrections(cell_ * n_points_ + p, corrections_);
      constexpr std::array<double, 16> constant{}; // within an increment
      for (const auto &[position, weight, stress] : corrections_)
      {
        const auto [a1, a2] = motion.now(position);
        const auto [a1_zero, a2_zero] = motion.before(position);
        const Layer layer{1. / a1, 1. / a2, motion.distance(position),
                          points_[cell_ * n_points_ + p].weight * weight * a1_zero * a2_zero};
        add_layer(layer, stress, constant.data(), total);
      }
    }

    /// @param t 4 x 4 moduli
    void add_layer(const Layer &layer, const Mandel &tau, const double *const t, Resultants &total) const
    {
      const auto [i1, i2, zeta, weight] = layer;
      const double s1 = weight * tau[0] * i1;
      const double s2 = axisymmetric_ ? weight * tau[1] * i2 : 0.;
      total.n[ShellStrain::stretch] += s1;
      total.n[ShellStrain::curvature] -= zeta * s1;
      total.n[ShellStrain::radius] += s2;
      total.n[ShellStrain::director_r] += zeta * s2;
      if (!tangent_)
        return;
      auto &g = total.g;
      const double k11 = weight * (t[0] - tau[0]) * i1 * i1;
      g[0][0] += k11;
      g[0][1] -= zeta * k11;
      g[1][1] += zeta * zeta * k11;
      if (!axisymmetric_)
        return;
      const double k12 = weight * t[1] * i1 * i2, k21 = weight * t[4] * i1 * i2;
      const double k22 = weight * (t[5] - tau[1]) * i2 * i2;
      g[0][2] += k12;
      g[0][3] += zeta * k12;
      g[1][2] -= zeta * k12;
      g[1][3] -= zeta * zeta * k12;
      g[2][0] += k21;
      g[3][0] += zeta * k21;
      g[2][1] -= zeta * k21;
      g[3][1] -= zeta * zeta * k21;
      g[2][2] += k22;
      g[2][3] += zeta * k22;
      g[3][3] += zeta * zeta * k22;
    }

    const ShellSpace &space_;
    const ShellPoints &points_;
    const ShellState &state_;
    MaterialPoints &material_;
    const ElasticCore &core_;
    bool axisymmetric_, tangent_;
    unsigned int n_points_, n_layers_;
    double stiffness_;

    unsigned int cell_ = 0;
    std::array<DofIndex, n_dofs> dofs_;
    std::array<double, n_dofs> residual_;
    std::array<double, n_dofs * n_dofs> matrix_;
    std::vector<double> moduli_;
    std::vector<Layer> layers_;
    std::vector<ElasticCore::Correction> corrections_;
    std::vector<ShellStrain> strains_; ///< of the points
  };
} // namespace deltaform
