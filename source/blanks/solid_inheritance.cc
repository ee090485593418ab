// What the children of a refined cell inherit: places, displacements, plastic state (doc/theory/solid.md).
#include "solid.h"

#include <deltaform/base/ranks.h>
#include <deltaform/kinematics/logarithmic_strain.h>

#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  namespace
  {
    /// All that a cell knows: places of its nodes, their values in every field, plastic state of its points.
    using CellData = std::vector<double>;

    /// Numbers of a point behind its history: ln C_p^-1 / 2, elastic strain, volume offset.
    constexpr std::size_t n_tensors = 9;

    /// A place of the unit cell of a child in its parent's.
    Point2 in_parent(const Point2 &xi, const unsigned int child)
    {
      const unsigned int right = child % 2, upper = child / 2;
      return {.5 * (xi[0] + right), .5 * (xi[1] + upper)};
    }

    /// Lagrange's polynomials of the points of Gauss's rule of the parent, at a place.
    std::vector<double> point_weights(const std::vector<Point2> &points, const Point2 &xi)
    {
      const auto n = static_cast<unsigned int>(std::lround(std::sqrt(points.size())));
      std::vector<double> result;
      const auto line = [&](const unsigned int i, const double x) {
        double product = 1.;
        for (unsigned int k = 0; k < n; ++k)
          if (k != i)
            product *= (x - points[k][0]) / (points[i][0] - points[k][0]);
        return product;
      };
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          result.push_back(line(i, xi[0]) * line(j, xi[1]));
      return result;
    }
  } // namespace


  std::vector<double> Solid::pack(const unsigned int cell, const std::vector<Vector> &fields) const
  {
    CellData data;
    for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
      for (unsigned int k = 0; k < 2; ++k)
        data.push_back(space_.nodes()[space_.cells()[cell][a]][k]);
    for (const auto &field : fields)
      for (unsigned int a = 0; a < space_.n_nodes_per_cell(); ++a)
        for (const auto dof : space_.dofs()[space_.cells()[cell][a]])
          data.push_back(field[dof]);
    for (unsigned int i = cell * points_.per_cell(); i < (cell + 1) * points_.per_cell(); ++i)
    {
      const double *const history = material_.history(i);
      data.insert(data.end(), history, history + material_.law().history_size());
      const auto &cp = plastic_metric_[i];
      const Mandel metric = LogarithmicStrain::strain({cp[0], cp[1], cp[2], cp[3]});
      data.insert(data.end(), metric.begin(), metric.end());
      const Mandel elastic = material_.law().elastic_strain(material_.committed_stress(i));
      data.insert(data.end(), elastic.begin(), elastic.end());
      data.push_back(volume_offset_[i]);
    }
    return data;
  }


  std::vector<double> Solid::inherit(const std::vector<double> &parent, const unsigned int child) const
  {
    // Displacements and places: exactly, since the parent's shape functions are among those of the children.
    const dealii::FE_Q<2> shapes(space_.degree());
    const std::size_t n = space_.n_nodes_per_cell(), n_points = points_.per_cell();
    const std::size_t n_history = material_.law().history_size();
    const std::size_t n_state = n_history + n_tensors, n_vectors = (parent.size() - n_points * n_state) / (2 * n);
    std::vector<std::vector<double>> weights(n, std::vector<double>(n));
    for (unsigned int b = 0; b < n; ++b)
      for (unsigned int a = 0; a < n; ++a)
      {
        const double weight = shapes.shape_value(a, in_parent(shapes.unit_support_point(b), child));
        const double round = std::round(weight);
        weights[b][a] = std::abs(weight - round) < 1e-13 ? round : weight; // old nodes keep their numbers exactly
      }
    CellData result(parent.size(), 0.);
    for (unsigned int v = 0; v < n_vectors; ++v)
      for (unsigned int b = 0; b < n; ++b)
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int k = 0; k < 2; ++k)
            result[2 * (v * n + b) + k] += weights[b][a] * parent[2 * (v * n + a) + k];
    if (n_history == 0)
      return result;

    // Plastic state: interpolated between the parent's points, towards their mean as far as the equivalent plastic
    // strain would leave the range that a linear one with these values has at the points of the children, or get
    // negative. The logarithm of C_p^-1 has no trace, whatever the weights.
    const double *const states = &parent[2 * n_vectors * n];
    const auto equivalent = [&](const double *const state) { return material_.law().equivalent_plastic_strain(state); };
    CellData mean(n_state, 0.), state(n_state);
    double least = equivalent(states), most = least;
    for (unsigned int p = 0; p < n_points; ++p)
    {
      least = std::min(least, equivalent(states + p * n_state));
      most = std::max(most, equivalent(states + p * n_state));
      for (unsigned int k = 0; k < n_state; ++k)
        mean[k] += states[p * n_state + k] / n_points;
    }
    const double middle = equivalent(mean.data());
    const double first = points_.unit_points().front()[0], reach = .5 * first / (1. - 2. * first);
    const double range = most - least;
    most += reach * range;
    least = std::max(0., least - reach * range);
    for (unsigned int p = 0; p < n_points; ++p)
    {
      const auto w = point_weights(points_.unit_points(), in_parent(points_.unit_points()[p], child));
      std::fill(state.begin(), state.end(), 0.);
      for (unsigned int s = 0; s < n_points; ++s)
        for (unsigned int k = 0; k < n_state; ++k)
          state[k] += w[s] * states[s * n_state + k];
      const double value = equivalent(state.data());
      // A little less, so that round-off does not make a strain negative.
      const double part = value > most    ? (1. - 1e-14) * (most - middle) / (value - middle)
                          : value < least ? (1. - 1e-14) * (least - middle) / (value - middle)
                                          : 1.;
      for (unsigned int k = 0; k < n_state; ++k)
        result[2 * n_vectors * n + p * n_state + k] = part == 1. ? state[k] : mean[k] + part * (state[k] - mean[k]);
    }
    return result;
  }


  void Solid::keep_elastic_strain(const std::vector<Mandel> &wanted)
  {
    // At displacements that did not change, children strain otherwise than their parent's points did: the less, the
    // less it was distorted. Where metal has flowed, that difference belongs to the flow and not to the elasticity,
    // whose strains are a thousand times smaller; where it has not, it is what the finer mesh knows better.
    const auto share = [&](const double plastic, const double flow_stress) {
      return plastic / (flow_stress / material_.law().young_modulus() + plastic);
    };
    for (unsigned int c = 0; c < space_.cells().size(); ++c)
    {
      double plastic = 0., flow_stress = 0.;
      for (unsigned int i = c * points_.per_cell(); i < (c + 1) * points_.per_cell(); ++i)
      {
        plastic += material_.equivalent_plastic_strain(i) / points_.per_cell();
        flow_stress += material_.flow_stress(i) / points_.per_cell();
      }
      const double volume_share = share(plastic, flow_stress);
      for (unsigned int i = c * points_.per_cell(); i < (c + 1) * points_.per_cell(); ++i)
      {
        // The law got the sum of the elastic strain and the plastic one of its history.
        Mandel trial = material_.strain(i);
        const Mandel old = material_.plastic_strain(i);
        for (unsigned int k = 0; k < 4; ++k)
          trial[k] -= old[k];
        const double mean = (trial[0] + trial[1] + trial[2]) / 3.;
        const double wanted_mean = (wanted[i][0] + wanted[i][1] + wanted[i][2]) / 3.;
        volume_offset_[i] += 3. * volume_share * (mean - wanted_mean);
        // Small strains are as linear in the cell as what is interpolated.
        if (!finite_)
          continue;
        const double own = share(material_.equivalent_plastic_strain(i),
                                 material_.flow_stress(i));
        Mandel kept;
        for (unsigned int k = 0; k < 4; ++k)
          kept[k] = (1. - own) * (trial[k] - (k < 3 ? mean : 0.)) + own * (wanted[i][k] - (k < 3 ? wanted_mean : 0.));
        set_plastic_metric(i, kept);
      }
    }
  }


  void Solid::unpack(const std::vector<std::vector<double>> &data, std::vector<Vector> &fields)
  {
    const std::size_t n = space_.n_nodes_per_cell(), n_history = material_.law().history_size();
    for (unsigned int v = 0; v < fields.size(); ++v)
    {
      fields[v].reinit(n_dofs());
      for (unsigned int c = 0; c < space_.cells().size(); ++c)
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int k = 0; k < 2; ++k)
            if (const DofIndex dof = space_.dofs()[space_.cells()[c][a]][k]; dof < n_dofs() &&
                                                                             space_.hanging().owned().is_element(dof))
              fields[v][dof] = data[c][2 * ((v + 1) * n + a) + k];
      ranks::sum(fields[v].begin(), fields[v].size());
    }
    const auto state_of = [&](const unsigned int point) {
      return &data[point / points_.per_cell()][2 * (fields.size() + 1) * n +
                                               point % points_.per_cell() * (n_history + n_tensors)];
    };
    std::vector<double> history;
    for (unsigned int i = 0; i < points_.size(); ++i)
    {
      const double *state = state_of(i);
      history.insert(history.end(), state, state + n_history);
      state += n_history;
      volume_offset_[i] = state[8];
      const auto b = LogarithmicStrain::inverse({{state[0], state[1], state[2], state[3]}});
      plastic_metric_[i] = {{b.xx, b.yy, b.zz, b.xy}};
    }
    material_.set_history(history);

    // Stresses of the law at the displacements as they came over, the scale of energies and the start of the next flow.
    Vector q = fields.empty() ? Vector(n_dofs()) : fields.front();
    update_stress(q);
    if (n_history > 0 && !fields.empty())
    {
      std::vector<Mandel> elastic;
      for (unsigned int i = 0; i < points_.size(); ++i)
      {
        const double *const state = state_of(i) + n_history + 4;
        elastic.push_back({{state[0], state[1], state[2], state[3]}});
      }
      keep_elastic_strain(elastic);
      update_stress(q);
    }
    constant_matrices_.clear();
    material_.keep_stress();
    committed_deformation_ = deformation_;
    if (material_.counts_energy())
    {
      double elastic = 0.;
      for (unsigned int i = 0; i < points_.size(); ++i)
        elastic += points_[i].weight * material_.law().elastic_energy(material_.stress(i));
      material_.add_energy(ranks::sum(elastic), 0.);
    }
    update_areas(q);
    update_thickness(q);
    update_places(q);
  }
} // namespace deltaform
