// Accepting an increment of the shell, its energies, its fields.
#include "shell.h"
#include "shell_point.h"

#include <deltaform/materials/flow_error.h>


namespace deltaform
{
  namespace
  {
    /// log(a / b) to the last digits; of neighbours by the series of atanh, a quarter of the time.
    double log_of_ratio(const double a, const double b)
    {
      const double x = (a - b) / (a + b), square = x * x;
      return square < 1e-5 ? 2. * x * (1. + square * (1. / 3. + square * (1. / 5. + square / 7.))) : std::log(a / b);
    }
  } // namespace


  void Shell::begin_increment(const double duration, const double ratio)
  {
    material_.begin_increment(duration, ratio);
  }


  double Shell::flow_error() const
  {
    MeanFlowError error;
    for (unsigned int i = 0; i < material_.size(); ++i)
      error.add(points_[i / n_layers_].weight * layer_weight_[i % n_layers_] *
                  (material_.flow(i)),
                material_.committed_stress(i),
                material_.stress(i));
    return error.value();
  }


  IncrementSize Shell::increment_size(const Vector &dq) const
  {
    IncrementSize largest;
    for (unsigned int i = 0; i < material_.size(); ++i)
      for (unsigned int k = 0; k < 2; ++k)
        largest.strain = std::max(largest.strain, std::abs(material_.strain(i)[k] - committed_strain_[i][k]));
    for (const auto &dofs : node_dofs_)
      largest.rotation = std::max(largest.rotation, std::abs(dq[dofs[2]]));
    return largest;
  }


  ShellStrain Shell::strain_at(const Vector &q, const unsigned int cell, const unsigned int point) const
  {
    const auto &nodes = mesh_.cells()[cell].nodes;
    std::array<DofIndex, 9> dofs{};
    for (unsigned int a = 0; a <= degree_; ++a)
      std::copy(node_dofs_[nodes[a]].begin(), node_dofs_[nodes[a]].end(), dofs.begin() + 3ul * a);
    const auto evaluate = [&](auto n_nodes, auto membrane) {
      return shell_strain<n_nodes, membrane>(
        points_[point], mesh_.cells()[cell], mesh_.nodes(), q, dofs.data(), axisymmetric_);
    };
    using Two = std::integral_constant<unsigned int, 2>;
    using Three = std::integral_constant<unsigned int, 3>;
    if (membrane_)
      return degree_ == 1 ? evaluate(Two(), std::true_type()) : evaluate(Three(), std::true_type());
    return degree_ == 1 ? evaluate(Two(), std::false_type()) : evaluate(Three(), std::false_type());
  }


  double Shell::membrane_angle(const Vector &q, const unsigned int node) const
  {
    const unsigned int before = node > 0 ? node - 1 : node,
                       after = std::min<unsigned int>(node + 1, node_dofs_.size() - 1);
    const Tensor1 chord = position(q, after) - position(q, before);
    return std::atan2(chord[1], chord[0]);
  }


  double Shell::thickness_strain_work(const unsigned int place,
                                      const ShellStrain &strain,
                                      const double new_ratio,
                                      const double *volume) const
  {
    // Moving the layers of a curved shell to the new thickness strains them at fixed displacements.
    if (new_ratio == thickness_ratio_[place])
      return 0.;
    double work = 0.;
    for (unsigned int l = 0; l < n_layers_; ++l)
    {
      const double before = thickness_ratio_[place] * layer_position_[l], after = new_ratio * layer_position_[l];
      const auto &tau = material_.stress(place * n_layers_ + l);
      work += volume[l] * tau[0] *
              log_of_ratio(strain.lambda - after * strain.theta_prime, strain.lambda - before * strain.theta_prime);
      if (axisymmetric_)
        work += volume[l] * tau[1] * log_of_ratio(strain.r + after * strain.d_r(), strain.r + before * strain.d_r());
    }
    return work;
  }


  void Shell::commit(const Vector &q)
  {
    const double shear = membrane_ ? 0. : shear_factor_ * material_.law().shear_modulus() * thickness_;
    double elastic = 0., plastic = 0., normal = 0.;
    std::vector<double> volumes(n_layers_);
    for (unsigned int c = 0, i = 0; c < mesh_.cells().size(); ++c)
      for (unsigned int p = 0; p < n_points_per_cell_; ++p)
      {
        const unsigned int place = c * n_points_per_cell_ + p;
        const ShellPoint &point = points_[place];
        const double sine = material_.counts_energy() && axisymmetric_ ? std::sin(point.angle) : 0.;
        double thickness = 0.;
        for (unsigned int l = 0; l < n_layers_; ++l, ++i)
        {
          thickness += layer_weight_[l] * std::exp(material_.strain(i)[2]);
          if (!material_.counts_energy())
            continue;
          const double volume = volumes[l] = layer_volume(point, sine, l);
          const Mandel before = material_.plastic_strain(i);
          const Mandel after = material_.trial_plastic_strain(i);
          const Mandel &start = material_.committed_stress(i), &end = material_.stress(i);
          double work = 0.;
          for (unsigned int k = 0; k < 4; ++k)
            work += (end[k] + start[k]) * (after[k] - before[k]);
          plastic += .5 * volume * work;
          normal += .5 * volume * (end[2] + start[2]) * (material_.strain(i)[2] - committed_strain_[i][2]);
          elastic += volume * material_.law().elastic_energy(end);
        }
        if (material_.counts_energy())
        {
          const ShellStrain strain = strain_at(q, c, place);
          const double gamma = strain.gamma - point.gamma;
          normal += thickness_strain_work(place, strain, thickness / thickness_, volumes.data());
          elastic += .5 * shear * point.weight * point.radius * gamma * gamma;
        }
        thickness_ratio_[place] = thickness / thickness_;
      }
    material_.add_energy(elastic, plastic, normal);
    material_.commit();
    committed_strain_ = material_.strains();

    std::vector<double> thickness(thickness_ratio_);
    for (auto &value : thickness)
      value *= thickness_;
    node_thickness_ = to_nodes(thickness);
    // The pressures are those that the transverse stress of this increment was made of.
    for (unsigned int i = 0; i < node_relief_.size() && transverse_normal_stress_; ++i)
      node_relief_[i] = .25 * node_thickness_[i] * (contact_pressure_[0][i] + contact_pressure_[1][i]) / modulus();
    update_areas(q);
  }


  std::vector<double> Shell::to_nodes(const std::vector<double> &point_values) const
  {
    std::vector<double> result(node_dofs_.size(), 0.);
    for (unsigned int c = 0; c < mesh_.cells().size(); ++c)
      for (unsigned int p = 0; p < n_points_per_cell_; ++p)
      {
        const ShellPoint &point = points_[c * n_points_per_cell_ + p];
        for (unsigned int a = 0; a <= degree_; ++a)
          result[mesh_.cells()[c].nodes[a]] +=
            std::abs(point.shape[a]) * point.weight * point.radius * point_values[c * n_points_per_cell_ + p];
      }
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] /= node_weight_[i];
    return result;
  }


  void Shell::set_contact_pressure(const Side side, const std::vector<double> &pressure)
  {
    // The mean stress across the thickness does not follow a pressure that varies over less than a thickness: average
    // it over that length. On meshes coarser than the thickness this changes nothing; on finer ones the force of a
    // single node is otherwise taken for a pressure far above the flow stress.
    auto &mean = contact_pressure_[static_cast<unsigned int>(side)];
    const auto &arc = mesh_.arc_length();
    const double window = .5 * thickness_ * (1 + 1e-9);
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
        force += pressure[j] * node_area_[j];
        area += node_area_[j];
      }
      if (area > 0)
        mean[i] = force / area;
    }
    if (!transverse_normal_stress_)
      return;
    for (unsigned int c = 0; c < mesh_.cells().size(); ++c)
      for (unsigned int p = 0; p < n_points_per_cell_; ++p)
      {
        const unsigned int place = c * n_points_per_cell_ + p;
        double sum = 0.;
        for (unsigned int a = 0; a <= degree_; ++a)
        {
          const unsigned int node = mesh_.cells()[c].nodes[a];
          sum += points_[place].shape[a] * (contact_pressure_[0][node] + contact_pressure_[1][node]);
        }
        for (unsigned int l = 0; l < n_layers_; ++l)
          third_stress_[place * n_layers_ + l] = -.5 * sum;
      }
  }


  void Shell::forget_energy()
  {
    material_.forget_energy();
  }


  BlankEnergy Shell::energy() const
  {
    return material_.energy();
  }


  double Shell::smallest_thickness() const
  {
    return thickness_ * *std::min_element(thickness_ratio_.begin(), thickness_ratio_.end());
  }


  std::vector<Point2> Shell::positions(const Vector &q) const
  {
    std::vector<Point2> result;
    for (unsigned int i = 0; i < node_dofs_.size(); ++i)
      result.push_back(position(q, i));
    return result;
  }


  void Shell::rigid_motion(const Vector &q,
                           const Tensor1 &translation,
                           const double rotation,
                           const std::function<void(DofIndex, double)> &set) const
  {
    for (unsigned int i = 0; i < node_dofs_.size(); ++i)
    {
      const Point2 x = position(q, i);
      set(node_dofs_[i][0], translation[0] - rotation * x[1]);
      set(node_dofs_[i][1], translation[1] + rotation * x[0]);
      set(node_dofs_[i][2], rotation);
    }
  }


  KeyedArrays Shell::state() const
  {
    KeyedArrays state;
    material_.put(state);
    state.put("strain", committed_strain_);
    state.put("thickness ratio", thickness_ratio_);
    state.put("thickness at nodes", node_thickness_);
    state.put("elastic recovery at nodes", node_relief_);
    state.put("area of nodes", node_area_);
    state.put("contact pressure, bottom", contact_pressure_[0]);
    state.put("contact pressure, top", contact_pressure_[1]);
    state.put("third stress", third_stress_);
    return state;
  }


  void Shell::set_state(const KeyedArrays &state)
  {
    material_.take(state);
    state.take("strain", committed_strain_);
    for (unsigned int i = 0; i < committed_strain_.size(); ++i)
      material_.strain(i) = committed_strain_[i];
    state.take("thickness ratio", thickness_ratio_);
    state.take("thickness at nodes", node_thickness_);
    state.take("elastic recovery at nodes", node_relief_);
    state.take("area of nodes", node_area_);
    state.take("contact pressure, bottom", contact_pressure_[0]);
    state.take("contact pressure, top", contact_pressure_[1]);
    state.take("third stress", third_stress_);
  }
} // namespace deltaform
