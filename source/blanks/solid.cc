#include "solid.h"
#include "held_forces.h"

#include <deltaform/materials/flow_error.h>
#include <deltaform/parameters/registry.h>
#include <deltaform/parameters/section.h>
#include <deltaform/process/ranks.h>

#include <algorithm>
#include <tuple>

namespace deltaform
{
  Solid::Solid(Section &section)
    : degree_(section.integer("Degree", 1, 1, 2, "Polynomial degree: 1 for bulk forming, 2 where a thin blank bends.")),
      axisymmetric_(section.choice("Symmetry",
                                   "axisymmetric",
                                   {"axisymmetric", "plane strain"},
                                   "Axisymmetric about r = 0 (forces for the full circumference) or plane strain (per "
                                   "unit width).") == "axisymmetric"),
      motion_(
        section.choice("Kinematics",
                       "finite",
                       {"finite", "small"},
                       "Finite strain, or displacements so small that the undeformed body serves for equilibrium.") ==
        "finite"),
      refinement_settings_(section.sub("Refinement")), body_(section, degree_, axisymmetric_, motion_.finite()),
      surface_(section, body_, material_, motion_.finite()),
      material_(section, ThirdDirection::strain_given, axisymmetric_),
      kernel_(body_, material_, motion_), transfer_(body_, material_, motion_, kernel_),
      refinement_(refinement_settings_, body_, surface_, material_, transfer_),
      fields_(body_, surface_, material_, motion_, flow_)
  {
    if (ranks::count() > 1 && surface_.points_per_edge() > 0)
      section.fail("Contact points", "points inside the edges want all of the solid in one process: use 'nodes'");
    if (section.documentation() && body_.space().mesh().boundaries().empty())
      return;
    if (material_.law().traits().symmetry != Symmetry::isotropic && !body_.space().mesh().is_strip())
      section.fail("File",
                   "an anisotropic metal wants to know how the sheet lies: build the body on a meridian (Points).");
    if (material_.law().heat())
      heat_.emplace(body_, material_, motion_);
    body_.set_up();
    body_.check(section);
    kernel_.reset();
    surface_.set_up(section);
    refinement_.update(Vector(n_dofs()));
    for (const auto &X : body_.space().nodes())
      outermost_ = std::max(outermost_, X[0]);
  }


  void Solid::touch_inside(const DeltaSize delta, const bool /*slides*/)
  {
    if (!motion_.finite() || delta == DeltaSize::fine)
      return;
    if (ranks::count() == 1)
      surface_.touch_inside();
    else
      shared_at_nodes_ = surface_.left_open();
  }


  const ContactSurface &Solid::surface() const
  {
    return surface_;
  }


  const Boundary &Solid::boundary() const
  {
    return body_.boundary();
  }


  const Fields &Solid::fields() const
  {
    return fields_;
  }


  Conducting *Solid::conducting()
  {
    return heat_ ? &*heat_ : nullptr;
  }


  Adaptive *Solid::adaptive()
  {
    return refinement_settings_.active ? &refinement_ : nullptr;
  }


  const Adaptive *Solid::adaptive() const
  {
    return refinement_settings_.active ? &refinement_ : nullptr;
  }


  unsigned int Solid::n_dofs() const
  {
    return body_.space().hanging().n_unknowns();
  }


  dealii::IndexSet Solid::locally_owned_dofs() const
  {
    return body_.space().hanging().owned();
  }


  void Solid::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    body_.space().add_couplings(pattern);
  }


  std::vector<DofIndex> Solid::fixed_dofs() const
  {
    return body_.space().axis_dofs();
  }


  double Solid::dof_scale(const DofIndex) const
  {
    return 1.;
  }


  std::string Solid::describe_dof(const DofIndex dof) const
  {
    return body_.space().describe(dof);
  }


  std::vector<Point2> Solid::positions(const Vector &q) const
  {
    return body_.space().positions(q);
  }


  void Solid::rigid_motion(const Vector &q,
                           const Tensor1 &translation,
                           const double rotation,
                           const std::function<void(DofIndex, double)> &set) const
  {
    body_.space().rigid_motion(q, translation, rotation, set);
  }


  bool Solid::axisymmetric() const
  {
    return axisymmetric_;
  }


  double Solid::initial_thickness() const
  {
    return body_.space().mesh().thickness();
  }


  double Solid::typical_length() const
  {
    return surface_.shortest_edge();
  }


  double Solid::stiffness_scale() const
  {
    // Of a node of cells that are about as long as high: E (per unit width), times the radius of the ring it stands
    // for.
    return material_.law().young_modulus() * (axisymmetric_ ? outermost_ : 1.);
  }


  double Solid::initial_flow_stress() const
  {
    return material_.initial_flow_stress();
  }


  bool Solid::depends_on_time() const
  {
    return material_.law().traits().needs_duration;
  }


  bool Solid::constant_stiffness() const
  {
    return kernel_.is_linear();
  }


  Status Solid::assemble(const Vector &q, AssemblyTarget &target)
  {
    return kernel_.assemble(q, target);
  }


  double Solid::admissible_step(const Vector &q, const Vector &dq) const
  {
    return kernel_.admissible_step(q, dq);
  }


  void Solid::follow_flow_stress(const Side side)
  {
    surface_.follow_flow_stress(side);
  }


  void Solid::begin_increment(const double duration, const double ratio)
  {
    surface_.begin_increment(ratio);
    if (material_.begin_increment(duration, ratio))
      motion_.turn_flow(material_, ratio);
  }


  Mandel Solid::start_stress(const std::size_t point, const Turn &turn) const
  {
    return motion_.finite() ? turn(material_.committed_stress(point)) : material_.committed_stress(point);
  }


  double Solid::flow_error() const
  {
    MeanFlowError error;
    for (unsigned int i = 0; i < material_.size(); ++i)
    {
      const double flow = material_.flow(i);
      const Mandel start = flow > 0. ? start_stress(i, motion_.turn(i)) : material_.committed_stress(i);
      error.add(body_.points()[i].weight * flow, start, material_.stress(i));
    }
    error.astray = ranks::sum(error.astray);
    error.flow = ranks::sum(error.flow);
    return error.value();
  }


  IncrementSize Solid::increment_size(const Vector &dq) const
  {
    // Where the law is linear, points are visited at the commit only.
    Vector storage;
    const SolidPoints &points = body_.points();
    const SolidIncrementSize size =
      kernel_.is_linear() ? SolidMotion::increment_size(points, body_.space().hanging().with_hanging(dq, storage))
                          : motion_.increment_size();
    IncrementSize own{size.strain, size.rotation};
    if (points.size() > 0)
    {
      own.strained = points.place(size.strained);
      own.turned = points.place(size.turned);
    }
    IncrementSize result;
    for (const IncrementSize &one : ranks::gather(std::vector<IncrementSize>{own}))
    {
      if (one.strain > result.strain)
        std::tie(result.strain, result.strained) = std::tie(one.strain, one.strained);
      if (one.rotation > result.rotation)
        std::tie(result.rotation, result.turned) = std::tie(one.rotation, one.turned);
    }
    return result;
  }


  void Solid::commit(const Vector &q)
  {
    if (kernel_.is_linear())
      kernel_.update_stress(q);
    const bool may_flow = material_.plastic();
    double elastic = 0., plastic = 0.;
    flow_.assign(may_flow ? material_.size() : 0, Mandel{});
    for (unsigned int i = 0; i < material_.size(); ++i)
    {
      const double volume = body_.points()[i].weight;
      if (material_.account().counts())
        elastic += volume * material_.law().elastic_energy(material_.stress(i));
      if (!may_flow)
        continue;
      const Turn turn = motion_.turn(i);
      motion_.remember_turn(i, turn);
      const Mandel before = material_.plastic_strain(i);
      const Mandel after = material_.trial_plastic_strain(i);
      if (before == after)
        continue;
      for (unsigned int k = 0; k < 4; ++k)
        flow_[i][k] = after[k] - before[k];
      if (material_.account().counts())
      {
        // The flow takes place in the axes of now: the last stress is turned along.
        const Mandel start = start_stress(i, turn);
        for (unsigned int k = 0; k < 4; ++k)
          plastic += .5 * volume * (material_.stress(i)[k] + start[k]) * flow_[i][k];
      }
      if (motion_.finite())
        motion_.flow_to(i, material_.law().elastic_strain(material_.stress(i)));
    }
    if (material_.account().counts())
      material_.account().add(ranks::sum(elastic), ranks::sum(plastic));
    material_.commit();
    motion_.commit();
    surface_.accept(q);
    refinement_.update(q);
  }


  BlankEnergy Solid::energy() const
  {
    return material_.account().sum();
  }


  void Solid::count_no_energy()
  {
    material_.account().stop();
  }


  KeyedArrays Solid::state() const
  {
    KeyedArrays state;
    refinement_.put(state);
    material_.put(state);
    SolidSurface::each_array(surface_, PutInto(state));
    SolidMotion::each_array(motion_, PutInto(state));
    return state;
  }


  void Solid::set_state(const KeyedArrays &state)
  {
    refinement_.take(state);
    material_.take(state);
    SolidSurface::each_array(surface_, TakeFrom(state));
    SolidMotion::each_array(motion_, TakeFrom(state));
    surface_.renew();
    motion_.start_from_committed();
    kernel_.turn_axes();
  }


  KeyedArrays Solid::formed(const Vector &q)
  {
    KeyedArrays result = Blank::formed(q);
    if (const auto &places = refinement_.first_places(); !places.empty())
      result.put("undeformed places of nodes", places);
    transfer_.describe(q, result);
    HeldForces(body_, kernel_).describe(q, result);
    return result;
  }


  bool Solid::goes_on_like(const KeyedArrays &formed) const
  {
    return transfer_.same_kind(formed) && has_nodes_of(formed) &&
           (refinement_settings_.active || !SolidRefinement::has_passes(formed));
  }


  TakenOver Solid::take_formed(const KeyedArrays &formed)
  {
    if (goes_on_like(formed))
    {
      KeyedArrays open = formed;
      surface_.leave_open(open);
      TakenOver taken = Blank::take_formed(open);
      surface_.update(taken.unknowns);
      return taken;
    }
    transfer_.cut_cells(formed);
    std::vector<Vector> fields(1);
    transfer_.take_over(fields);
    Vector &q = fields.front();
    for (const auto dof : fixed_dofs())
      q[dof] = 0.;
    surface_.update(q);
    refinement_.update(q);
    return {q, HeldForces(body_, kernel_).come_over(formed)};
  }


  static const Registry<Blank>::Entry
    entry("solid",
          "solid of quadrilaterals, axisymmetric or plane strain: finite or small strain",
          &make_as<Solid, Blank>);
} // namespace deltaform
