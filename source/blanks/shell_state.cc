#include "shell_state.h"

#include "foreseen_values.h"

#include <algorithm>
#include <cmath>

namespace deltaform
{
  ShellState::ShellState(const ShellSettings &settings, const ShellSpace &space, const ShellPoints &points)
    : space_(space), points_(points), transverse_normal_stress_(settings.transverse_normal_stress)
  {
    set_up();
  }


  void ShellState::set_up()
  {
    const unsigned int n = space_.n_nodes();
    strain_.assign(static_cast<std::size_t>(points_.size()) * points_.n_layers(), Mandel{});
    thickness_ratio_.assign(points_.size(), 1.);
    ratio_change_.assign(points_.size(), 0.);
    layer_ratio_ = accepted_layer_ratio_ = thickness_ratio_;
    layer_force_.assign(points_.size(), 0.);
    node_thickness_.assign(n, points_.thickness());
    node_recovery_.assign(n, 0.);
    thickness_change_.assign(n, 0.);
    face_thickness_ = node_thickness_;
    third_stress_.assign(strain_.size(), 0.);
    contact_pressure_.fill(std::vector<double>(n, 0.));
    present_pressure_ = contact_pressure_;
  }


  double ShellState::smallest_thickness() const
  {
    return points_.thickness() * *std::min_element(thickness_ratio_.begin(), thickness_ratio_.end());
  }


  void ShellState::begin_increment(const double ratio)
  {
    for (unsigned int i = 0; i < face_thickness_.size(); ++i)
      face_thickness_[i] = node_thickness_[i] + std::max(0., ratio * thickness_change_[i]);
    for (unsigned int p = 0; p < layer_ratio_.size(); ++p)
      layer_ratio_[p] = foreseen(thickness_ratio_[p], ratio_change_[p], ratio);
  }


  void ShellState::renew()
  {
    begin_increment(0.);
    layer_ratio_ = accepted_layer_ratio_;
    present_pressure_ = contact_pressure_;
    if (transverse_normal_stress_)
      update_third_stress();
  }


  void ShellState::set_contact_pressure(const FaceValues &pressure, const std::vector<double> &areas)
  {
    for (unsigned int side = 0; side < 2; ++side)
      average(pressure[side], areas, present_pressure_[side]);
    if (transverse_normal_stress_)
      update_third_stress();
  }


  double ShellState::change_of_transverse_stress(const FaceValues &pressure, const std::vector<double> &areas) const
  {
    double change = 0.;
    if (!transverse_normal_stress_)
      return change;
    FaceValues mean = present_pressure_;
    for (unsigned int side = 0; side < 2; ++side)
      average(pressure[side], areas, mean[side]);
    const auto &old = present_pressure_;
    for (unsigned int i = 0; i < mean[0].size(); ++i)
      change = std::max(change, .5 * std::abs(mean[0][i] + mean[1][i] - old[0][i] - old[1][i]));
    return change;
  }


  void ShellState::average(const std::vector<double> &pressure,
                           const std::vector<double> &areas,
                           std::vector<double> &mean) const
  {
    // The mean stress across the thickness does not follow a pressure that varies over less than a thickness: average
    // it over that length. On meshes coarser than the thickness this changes nothing; on finer ones the force of a
    // single node is otherwise taken for a pressure far above the flow stress.
    const auto &arc = space_.mesh().arc_length();
    const double window = .5 * points_.thickness() * (1 + 1e-9);
    for (unsigned int i = 0, first = 0, next_loaded = 0; i < mean.size(); ++i)
    {
      while (arc[i] - arc[first] > window)
        ++first;
      next_loaded = std::max(next_loaded, first);
      while (next_loaded < mean.size() && pressure[next_loaded] == 0.)
        ++next_loaded;
      mean[i] = 0.;
      if (next_loaded == mean.size() || arc[next_loaded] - arc[i] > window)
        continue;
      double force = 0., area = 0.;
      for (unsigned int j = first; j < mean.size() && arc[j] - arc[i] <= window; ++j)
      {
        force += pressure[j] * areas[j];
        area += areas[j];
      }
      if (area > 0)
        mean[i] = force / area;
    }
  }


  void ShellState::update_third_stress()
  {
    const auto &cells = space_.mesh().cells();
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int p = c * points_.per_cell(); p < (c + 1) * points_.per_cell(); ++p)
      {
        double sum = 0.;
        for (unsigned int a = 0; a <= space_.degree(); ++a)
        {
          const unsigned int node = cells[c].nodes[a];
          sum += points_[p].shape[a] * (present_pressure_[0][node] + present_pressure_[1][node]);
        }
        for (unsigned int l = 0; l < points_.n_layers(); ++l)
          third_stress_[p * points_.n_layers() + l] = -.5 * sum;
      }
  }


  double ShellState::accept_thickness(const std::size_t point, const double ratio, const double force)
  {
    const double work = .5 * (layer_force_[point] + force) * (layer_ratio_[point] - accepted_layer_ratio_[point]);
    ratio_change_[point] = ratio - thickness_ratio_[point];
    thickness_ratio_[point] = ratio;
    accepted_layer_ratio_[point] = layer_ratio_[point];
    layer_force_[point] = force;
    return work;
  }


  void ShellState::commit(const std::vector<Mandel> &strains, const double modulus)
  {
    strain_ = strains;
    std::vector<double> thickness(thickness_ratio_);
    for (auto &value : thickness)
      value *= points_.thickness();
    thickness = points_.to_nodes(thickness);
    for (unsigned int i = 0; i < thickness.size(); ++i)
      thickness_change_[i] = thickness[i] - node_thickness_[i];
    node_thickness_ = face_thickness_ = thickness;
    contact_pressure_ = present_pressure_;
    for (unsigned int i = 0; i < node_recovery_.size() && transverse_normal_stress_; ++i)
      node_recovery_[i] = .25 * node_thickness_[i] * (contact_pressure_[0][i] + contact_pressure_[1][i]) / modulus;
  }
} // namespace deltaform
