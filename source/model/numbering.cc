#include <deltaform/model/numbering.h>
#include <deltaform/process/ranks.h>

#include <algorithm>

namespace deltaform
{
  Numbering::Numbering(Actors &actors)
    : n_blank(actors.blank->n_dofs()), n_sparse(n_blank)
  {
    const Blank &blank = *actors.blank;
    const bool multipliers = actors.contact && actors.contact->normal_law->has_multiplier();
    std::vector<DofIndex> first_multiplier;
    for (const auto &interface : actors.interfaces)
    {
      first_multiplier.push_back(n_sparse);
      n_sparse += multipliers ? interface->n_points() : 0;
    }
    share_rows(blank);
    const Vector zero(n_blank);
    for (unsigned int p = 0; p < actors.interfaces.size(); ++p)
    {
      ContactInterface &interface = *actors.interfaces[p];
      interface.set_dofs(n_sparse + n_border, first_multiplier[p]);
      n_border += interface.projector().counterpart().n_unknowns();
      for (unsigned int i = 0; i < interface.n_points(); ++i)
      {
        const ContactPoint node = interface.point(zero, i);
        contact_unknowns.insert(contact_unknowns.end(), node.dofs.begin(), node.dofs.begin() + node.n_dofs);
        if (multipliers)
          contact_unknowns.push_back(interface.multiplier_dof(i));
      }
    }
    for (const auto &load : actors.loads)
    {
      if (load->follows_way())
        load->set_unknown(n_sparse + n_border++);
      for (const auto &interface : actors.interfaces)
        if (interface->tool().force_driven() && interface->tool().name() == load->lifted_tool())
          load->set_tool_unknown(interface->travel_dof());
    }
    is_fixed.assign(n(), false);
    for (const auto dof : blank.fixed_dofs())
      is_fixed[dof] = true;
    measure(blank);
    // The size of a load compares with displacements by its forces over a stiffness, its row by the inverse.
    for (const auto &load : actors.loads)
      if (load->follows_way())
        scale[load->unknown()] = load->unit_force(n()) / blank.stiffness_scale();
  }


  void Numbering::share_rows(const Blank &blank)
  {
    const auto of_blank = blank.locally_owned_dofs();
    const bool is_last = ranks::mine() + 1 == ranks::count();
    const bool all_of_blank = ranks::max(of_blank.n_elements() != n_blank ? 1. : 0.) == 0.;
    owned = dealii::IndexSet(n_sparse);
    for (const auto i : of_blank)
      owned.add_index(i);
    if (all_of_blank || is_last)
      owned.add_range(n_blank, n_sparse);
  }


  void Numbering::measure(const Blank &blank)
  {
    const Vector zero(n_blank);
    for (unsigned int d = 0; d < 2; ++d)
    {
      translation[d].reinit(n_blank);
      blank.rigid_motion(zero, d == 0 ? Tensor1({1., 0.}) : Tensor1({0., 1.}), 0.,
                         [&](const DofIndex dof, const double value) { translation[d][dof] = value; });
    }
    double extent = blank.initial_thickness();
    for (const auto &x : blank.positions(zero))
      extent = std::max(extent, x.norm());
    size.assign(n(), extent);
    scale.assign(n(), 1.);
    for (unsigned int i = 0; i < n_blank; ++i)
    {
      scale[i] = blank.dof_scale(i);
      if (scale[i] != 1.)
        size[i] = 1.; // an angle
    }
    for (unsigned int i = n_blank; i < n_sparse; ++i)
      scale[i] = 1. / blank.stiffness_scale();
  }


  Tensor1 Numbering::resultant(const Vector &forces) const
  {
    Tensor1 sum;
    for (DofIndex i = 0; i < n_blank; ++i)
      for (unsigned int d = 0; d < 2; ++d)
        sum[d] += translation[d][i] * forces[i];
    return sum;
  }


  std::vector<Vector> Numbering::rigid_motions(const Blank &blank) const
  {
    const Vector zero(n_blank);
    std::vector<Vector> motions;
    for (const auto &motion : {std::array<double, 3>{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}})
    {
      Vector v(n());
      blank.rigid_motion(zero, Tensor1({motion[0], motion[1]}), motion[2],
                         [&](const DofIndex dof, const double value) { v[dof] = value; });
      v /= v.linfty_norm();
      motions.push_back(v);
    }
    return motions;
  }
} // namespace deltaform
