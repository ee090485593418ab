// Numbering: unknowns of the blank, of the pairs and of the travels; the matrix with its pattern.
#include <deltaform/base/ranks.h>
#include <deltaform/model/forming_problem.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltaform
{
  FormingProblem::FormingProblem(Actors &actors, const LinearSolverSettings &linear_solver, Timers &timers)
    : actors_(actors), linear_solver_(linear_solver), timers_(timers),
      timer_clear_(timers.section("2 clear matrix and residual")),
      timer_blank_(timers.section("3-6 blank: strains, material, residual, tangent")),
      timer_sum_(timers.section("6 sum over processes")),
      timer_contact_(timers.section("7-9 contact: projection, forces, tangent")),
      timer_commit_(timers.section("12 commit")), augmentation_(8)
  {
    number_unknowns();
    state_.tool_forces.resize(actors_.tools.size());
    state_.travels.resize(actors_.tools.size());
    state_.load_resultants.resize(actors_.loads.size());
    for (unsigned int i = 0; i < actors_.tools.size(); ++i)
      state_.travels[i] = actors_.tools[i]->force_driven() ? 0. : actors_.tools[i]->travel(0.);
  }


  void FormingProblem::number_unknowns()
  {
    const unsigned int n_blank = actors_.blank->n_dofs();
    const bool multipliers = actors_.contact && actors_.contact->enforcement->has_multiplier();
    unsigned int n_sparse = n_blank, n_border = 0;
    std::vector<DofIndex> first_multiplier;
    for (const auto &pair : actors_.pairs)
    {
      first_multiplier.push_back(n_sparse);
      n_sparse += multipliers ? pair->n_nodes() : 0;
    }

    dealii::DynamicSparsityPattern pattern(n_sparse, n_sparse);
    actors_.blank->add_couplings(pattern);
    // Multipliers live behind the last rows of the blank.
    const auto of_blank = actors_.blank->locally_owned_dofs();
    const bool is_last = ranks::mine() + 1 == ranks::count();
    const bool all_of_blank = ranks::max(of_blank.n_elements() != n_blank ? 1. : 0.) == 0.;
    dealii::IndexSet owned(n_sparse);
    for (const auto i : of_blank)
      owned.add_index(i);
    if (all_of_blank || is_last)
      owned.add_range(n_blank, n_sparse);
    for (const auto i : owned)
      pattern.add(i, i);
    const Vector zero(n_blank);
    for (unsigned int p = 0; p < actors_.pairs.size(); ++p)
    {
      auto &pair = *actors_.pairs[p];
      pair.set_dofs(n_sparse + n_border, first_multiplier[p]);
      n_border += pair.tool().force_driven();
      if (multipliers)
        for (unsigned int i = 0; i < pair.n_nodes(); ++i)
        {
          const ContactNode node = pair.node(zero, i);
          for (unsigned int k = 0; k < node.n_dofs; ++k)
          {
            if (owned.is_element(node.dofs[k]))
              pattern.add(node.dofs[k], first_multiplier[p] + i);
            if (owned.is_element(first_multiplier[p] + i))
              pattern.add(first_multiplier[p] + i, node.dofs[k]);
          }
        }
    }
    const std::size_t width = front_width(pattern);
    linear_solver_.choose(n_sparse, width);
    // Newton holds on to the object.
    if (system_)
      *system_ = System(std::move(pattern), n_border, linear_solver_, owned);
    else
      system_ = std::make_unique<System>(std::move(pattern), n_border, linear_solver_, owned);

    const unsigned int n = n_sparse + n_border;
    state_.unknowns.reinit(n);
    prescribed_.reinit(n);
    state_.hold.reinit(n);
    state_.released.reset(n, actors_.tools.size(), actors_.supports.size(), actors_.loads.size());
    state_.load_forces.reinit(n);
    state_.reactions.reinit(n);
    for (unsigned int d = 0; d < 2; ++d)
    {
      translation_[d].reinit(n_blank);
      actors_.blank->rigid_motion(zero,
                                  d == 0 ? Tensor1({1., 0.}) : Tensor1({0., 1.}),
                                  0.,
                                  [&](const DofIndex dof, const double value) { translation_[d][dof] = value; });
    }
    is_fixed_.assign(n, false);
    for (const auto dof : actors_.blank->fixed_dofs())
      is_fixed_[dof] = true;
    is_prescribed_ = is_fixed_;
    if (on_linear_path())
      system_->keep_constant_part(contact_unknowns(), std::clamp<std::size_t>(width / 2, 100, 600));
    if (on_linear_path() || linear_solver_.iterative())
      describe_rigid_motions();
    double extent = actors_.blank->initial_thickness();
    for (const auto &x : actors_.blank->positions(zero))
      extent = std::max(extent, x.norm());
    size_.assign(n, extent);
    for (unsigned int i = 0; i < n_blank; ++i)
      if (actors_.blank->dof_scale(i) != 1.)
        size_[i] = 1.; // an angle
    // A multiplier is a force: divided by a stiffness it compares with displacements, its row (a gap) times it with
    // forces.
    scale_.assign(n, 1.);
    for (unsigned int i = 0; i < n_blank; ++i)
      scale_[i] = actors_.blank->dof_scale(i);
    for (unsigned int i = n_blank; i < n_sparse; ++i)
      scale_[i] = 1. / actors_.blank->stiffness_scale();
  }


  std::vector<DofIndex> FormingProblem::contact_unknowns() const
  {
    std::vector<DofIndex> result;
    const Vector zero(actors_.blank->n_dofs());
    for (const auto &pair : actors_.pairs)
      for (unsigned int i = 0; i < pair->n_nodes(); ++i)
      {
        const ContactNode node = pair->node(zero, i);
        result.insert(result.end(), node.dofs.begin(), node.dofs.begin() + node.n_dofs);
        if (actors_.contact->enforcement->has_multiplier())
          result.push_back(pair->multiplier_dof(i));
      }
    return result;
  }


  void FormingProblem::describe_rigid_motions()
  {
    const Vector zero(actors_.blank->n_dofs());
    std::vector<Vector> motions;
    for (const auto &motion : {std::array<double, 3>{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}})
    {
      Vector v(state_.unknowns.size());
      actors_.blank->rigid_motion(zero,
                                  Tensor1({motion[0], motion[1]}),
                                  motion[2],
                                  [&](const DofIndex dof, const double value) { v[dof] = value; });
      v /= v.linfty_norm();
      motions.push_back(v);
    }
    system_->set_near_null_space(motions);
  }
} // namespace deltaform
