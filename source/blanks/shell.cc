#include "shell.h"
#include "shell_sections.h"
#include "shell_transfer.h"

#include <deltaform/materials/flow_error.h>
#include <deltaform/parameters/registry.h>

#include <algorithm>
#include <cmath>

namespace deltaform
{
  Shell::Shell(Section &section)
    : settings_(section), space_(section, settings_), points_(section, settings_, space_),
      state_(settings_, space_, points_), surface_(section, space_, points_, material_, state_),
      boundary_(space_, surface_, settings_.thickness),
      material_(section, ThirdDirection::stress_given, settings_.axisymmetric),
      core_(points_, material_, points_.with_elastic_core()),
      kernel_(settings_, space_, points_, state_, material_, core_),
      fields_(space_, points_, state_, surface_, material_, kernel_),
      parts_(space_, points_, state_, surface_, material_, core_), refinement_(section.sub("Refinement"), parts_)
  {
    material_.reset(static_cast<std::size_t>(points_.size()) * points_.n_layers());
  }


  const ContactSurface &Shell::surface() const
  {
    return surface_;
  }


  const Boundary &Shell::boundary() const
  {
    return boundary_;
  }


  const Fields &Shell::fields() const
  {
    return fields_;
  }


  Adaptive *Shell::adaptive()
  {
    return refinement_.active() ? &refinement_ : nullptr;
  }


  const Adaptive *Shell::adaptive() const
  {
    return refinement_.active() ? &refinement_ : nullptr;
  }


  unsigned int Shell::n_dofs() const
  {
    return space_.n_dofs();
  }


  const ElementChain &Shell::chain() const
  {
    return space_.chain();
  }


  void Shell::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    space_.add_couplings(pattern);
  }


  std::vector<DofIndex> Shell::fixed_dofs() const
  {
    return space_.fixed_dofs();
  }


  double Shell::dof_scale(const DofIndex dof) const
  {
    return space_.is_rotation(dof) ? settings_.thickness : 1.;
  }


  std::string Shell::describe_dof(const DofIndex dof) const
  {
    return space_.describe(dof);
  }


  std::vector<Point2> Shell::positions(const Vector &q) const
  {
    return space_.positions(q);
  }


  void Shell::rigid_motion(const Vector &q,
                           const Tensor1 &translation,
                           const double rotation,
                           const std::function<void(DofIndex, double)> &set) const
  {
    space_.rigid_motion(q, translation, rotation, set);
  }


  bool Shell::axisymmetric() const
  {
    return settings_.axisymmetric;
  }


  double Shell::initial_thickness() const
  {
    return settings_.thickness;
  }


  double Shell::typical_length() const
  {
    return settings_.thickness;
  }


  double Shell::stiffness_scale() const
  {
    return material_.law().young_modulus() * settings_.thickness;
  }


  double Shell::initial_flow_stress() const
  {
    return material_.initial_flow_stress();
  }


  bool Shell::depends_on_time() const
  {
    return material_.law().traits().needs_duration;
  }


  Status Shell::assemble(const Vector &q, AssemblyTarget &target)
  {
    return kernel_.assemble(q, target);
  }


  double Shell::admissible_step(const Vector &q, const Vector &dq) const
  {
    return space_.admissible_step(q, dq);
  }


  void Shell::touch_inside(const DeltaSize delta, const bool slides)
  {
    // Nothing but friction holds a strip on a tool: it would snap from one point to the next (doc/decisions/README.md,
    // "Points inside, and a fine delta"), and from node to node as well, unless the points move (there, "A contact
    // point that moves").
    const bool snaps = delta == DeltaSize::fine && !axisymmetric();
    if (!snaps || slides)
      surface_.touch_inside(snaps);
  }


  void Shell::follow_flow_stress(const Side side)
  {
    surface_.follow_flow_stress(side);
  }


  void Shell::begin_increment(const double duration, const double ratio)
  {
    material_.begin_increment(duration, ratio);
    state_.begin_increment(ratio);
    surface_.begin_increment(ratio);
  }


  double Shell::flow_error() const
  {
    const unsigned int n_layers = points_.n_layers();
    MeanFlowError error;
    for (unsigned int i = 0; i < material_.size(); ++i)
      error.add(points_[i / n_layers].weight * points_.layer_weight(i % n_layers) * material_.flow(i),
                material_.committed_stress(i),
                material_.stress(i));
    return error.value();
  }


  IncrementSize Shell::increment_size(const Vector &dq) const
  {
    IncrementSize largest;
    unsigned int strained = 0, turned = 0;
    for (unsigned int i = 0; i < material_.size(); ++i)
      for (unsigned int k = 0; k < 2; ++k)
        if (const double strain = std::abs(material_.strain(i)[k] - state_.strain(i)[k]); strain > largest.strain)
        {
          largest.strain = strain;
          strained = i / points_.n_layers();
        }
    for (unsigned int i = 0; i < space_.n_nodes(); ++i)
      if (const double rotation = std::abs(dq[space_.dofs()[i][2]]); rotation > largest.rotation)
      {
        largest.rotation = rotation;
        turned = i;
      }
    largest.strained = points_.place(strained);
    largest.turned = space_.mesh().nodes()[turned];
    return largest;
  }


  std::vector<SheetSection> Shell::trial_sections() const
  {
    std::vector<double> thickness(points_.size());
    for (unsigned int p = 0; p < points_.size(); ++p)
      thickness[p] = trial_thickness(p);
    thickness = points_.to_nodes(thickness);
    return shell_sections(
      space_, points_, [&](const unsigned int i) { return thickness[i]; },
      [&](const unsigned int i) { return material_.strain(i)[0]; },
      [&](const unsigned int i) { return material_.stress(i)[0]; });
  }


  double Shell::trial_thickness(const unsigned int place) const
  {
    double thickness = 0.;
    for (unsigned int l = 0; l < points_.n_layers(); ++l)
      thickness += points_.layer_weight(l) * std::exp(material_.strain(place * points_.n_layers() + l)[2]);
    return thickness;
  }


  double Shell::layer_force(const ShellStrain &strain, const unsigned int place) const
  {
    const ShellPoint &point = points_[place];
    const double sine = settings_.axisymmetric ? std::sin(point.angle) : 0., ratio = state_.layer_ratio(place);
    double force = 0.;
    for (unsigned int l = 0; l < points_.n_layers(); ++l)
    {
      const double position = points_.layer_position(l), zeta = ratio * position;
      const auto &tau = material_.stress(place * points_.n_layers() + l);
      double rate = -tau[0] * position * strain.theta_prime / (strain.lambda - zeta * strain.theta_prime);
      if (settings_.axisymmetric)
        rate += tau[1] * position * strain.d_r() / (strain.r + zeta * strain.d_r());
      force += points_.layer_volume(point, sine, l) * rate;
    }
    return force / (point.weight * point.radius);
  }


  void Shell::add_energy(const ShellStrain &strain, const unsigned int place, BlankEnergy &sum) const
  {
    const ShellPoint &point = points_[place];
    const unsigned int n_layers = points_.n_layers();
    const double sine = settings_.axisymmetric ? std::sin(point.angle) : 0.;
    for (unsigned int l = 0, i = place * n_layers; l < n_layers; ++l, ++i)
    {
      const double volume = points_.layer_volume(point, sine, l);
      const Mandel before = material_.plastic_strain(i);
      const Mandel after = material_.trial_plastic_strain(i);
      const Mandel &start = material_.committed_stress(i), &end = material_.stress(i);
      double work = 0.;
      for (unsigned int k = 0; k < 4; ++k)
        work += (end[k] + start[k]) * (after[k] - before[k]);
      sum.plastic += volume * (.5 * work + material_.dissipation_of_stiffness(i));
      sum.normal += .5 * volume * (end[2] + start[2]) * (material_.strain(i)[2] - state_.strain(i)[2]);
      sum.elastic += volume * material_.stored_energy(i);
    }
    const double gamma = strain.gamma - point.gamma;
    if (core_.follows())
      sum.plastic += core_work(place);
    sum.elastic += .5 * kernel_.shear_stiffness() * point.weight * point.radius * gamma * gamma;
  }


  double Shell::core_work(const unsigned int place) const
  {
    const unsigned int n_layers = points_.n_layers();
    std::array<Mandel, 2> change;
    for (unsigned int end = 0; end < 2; ++end)
    {
      const std::size_t i = static_cast<std::size_t>(place) * n_layers + end * (n_layers - 1);
      for (unsigned int k = 0; k < 4; ++k)
        change[end][k] = material_.strain(i)[k] - state_.strain(i)[k];
    }
    return points_[place].weight * points_[place].radius * core_.work(place, change[0], change[1]);
  }


  void Shell::commit(const Vector &q)
  {
    BlankEnergy sum;
    for (unsigned int place = 0; place < points_.size(); ++place)
    {
      const ShellStrain strain = points_.strain(q, place / points_.per_cell(), place);
      double force = 0.; // on an area
      if (material_.account().counts())
      {
        add_energy(strain, place, sum);
        force = layer_force(strain, place);
      }
      if (core_.follows())
        core_.commit(place,
                     {points_[place], strain, state_.layer_ratio(place), settings_.axisymmetric},
                     *state_.third_stress(static_cast<std::size_t>(place) * points_.n_layers()));
      sum.normal += points_[place].weight * points_[place].radius *
                    state_.accept_thickness(place, trial_thickness(place) / settings_.thickness, force);
    }
    material_.account().add(sum.elastic, sum.plastic, sum.normal);
    material_.commit();
    state_.commit(material_.strains(), surface_.modulus());
    surface_.accept(q);
    refinement_.update(q);
  }


  bool Shell::feels_pressure() const
  {
    return true;
  }


  void Shell::set_pressure(const FaceValues &pressure)
  {
    state_.set_contact_pressure(pressure, surface_.areas());
    // A pressure that could not be foreseen has changed the thickness as little foreseen.
    for (unsigned int place = 0; place < points_.size(); ++place)
      state_.set_layer_ratio(place, trial_thickness(place) / settings_.thickness);
  }


  double Shell::pressure_change(const FaceValues &pressure) const
  {
    return state_.change_of_transverse_stress(pressure, surface_.areas()) / material_.initial_flow_stress();
  }


  BlankEnergy Shell::energy() const
  {
    return material_.account().sum();
  }


  void Shell::count_no_energy()
  {
    material_.account().stop();
  }


  KeyedArrays Shell::state() const
  {
    KeyedArrays state = parts_.whole_state();
    refinement_.put(state);
    return state;
  }


  void Shell::set_state(const KeyedArrays &state)
  {
    refinement_.take(state);
    parts_.set_state(state);
  }


  KeyedArrays Shell::formed(const Vector &q)
  {
    KeyedArrays result = Blank::formed(q);
    result.put("undeformed places of nodes", refinement_.first_places());
    ShellTransfer(space_, points_, material_, ShellTransfer::Correspondence::place).describe(q, result);
    return result;
  }


  TakenOver Shell::take_formed(const KeyedArrays &formed)
  {
    if (formed.has("elastic core") != core_.follows())
      throw SceneError("the earlier operation had another Blank/Layer rule: it must stay");
    // Where this blank touches is its own: the areas of the contact points are those of the mesh as it comes over.
    if (has_nodes_of(formed) && (refinement_.active() || !ShellRefinement::is_refined(formed)))
    {
      refinement_.take(formed);
      KeyedArrays whole = formed;
      ShellSurface::each_array(surface_, PutInto(whole));
      whole.put("undeformed places of nodes", space_.mesh().nodes());
      TakenOver taken = Blank::take_formed(whole);
      surface_.update(taken.unknowns);
      return taken;
    }
    const ShellTransfer transfer(space_, points_, material_, ShellTransfer::Correspondence::place);
    const Vector q = parts_.come_over(transfer, formed);
    BlankEnergy sum;
    for (unsigned int place = 0; place < points_.size(); ++place)
      add_energy(points_.strain(q, place / points_.per_cell(), place), place, sum);
    material_.account().add(sum.elastic, 0.);
    return {q, std::nullopt};
  }


  static const Registry<Blank>::Entry
    entry("shell", "shell of revolution, or strip in plane strain: bending, finite strain", &make_as<Shell, Blank>);
} // namespace deltaform
