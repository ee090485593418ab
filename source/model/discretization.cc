#include <deltaform/model/discretization.h>

#include <algorithm>
#include <utility>

namespace deltaform
{
  Discretization::Discretization(Actors &actors, const LinearSolverSettings &linear_solver,
                                 std::vector<const Term *> terms)
    : actors_(actors), linear_solver_(linear_solver), terms_(std::move(terms))
  {
    renumber();
  }


  void Discretization::renumber()
  {
    numbering_ = Numbering(actors_);
    dealii::DynamicSparsityPattern pattern(numbering_.n_sparse, numbering_.n_sparse);
    add_couplings(pattern);
    front_width_ = front_width(pattern);
    linear_solver_.choose(numbering_.n_sparse, front_width_);
    ++n_meshes_;
  }


  void Discretization::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    for (const Term *const term : terms_)
      term->add_couplings(pattern);
    for (const auto i : numbering_.owned)
      pattern.add(i, i);
  }


  System Discretization::make_system() const
  {
    dealii::DynamicSparsityPattern pattern(numbering_.n_sparse, numbering_.n_sparse);
    add_couplings(pattern);
    System system(std::move(pattern), numbering_.n_border, linear_solver_, numbering_.owned);
    if (on_linear_path())
      system.keep_constant_part(numbering_.contact_unknowns, std::clamp<std::size_t>(front_width_ / 2, 100, 600));
    if (on_linear_path() || linear_solver_.iterative())
      system.set_near_null_space(numbering_.rigid_motions(*actors_.blank));
    return system;
  }
} // namespace deltaform
